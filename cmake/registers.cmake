# tripoint::contract: the register map as a header, made anew whenever registers.toml or its generator changes.
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)

set(TRIPOINT_GENERATED ${PROJECT_BINARY_DIR}/generated)
file(GLOB generator CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/register_map/*.py)
add_custom_command(
  OUTPUT ${TRIPOINT_GENERATED}/contract/registers.h
  COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/cmake/registers.py header ${TRIPOINT_GENERATED}/contract/registers.h
  DEPENDS ${PROJECT_SOURCE_DIR}/firmware/contract/registers.toml ${PROJECT_SOURCE_DIR}/cmake/registers.py ${generator}
  COMMENT "Making contract/registers.h"
  VERBATIM)
add_custom_target(tripoint_generated DEPENDS ${TRIPOINT_GENERATED}/contract/registers.h)
add_library(tripoint_contract INTERFACE)
add_dependencies(tripoint_contract tripoint_generated)
target_include_directories(tripoint_contract INTERFACE ${TRIPOINT_GENERATED})
add_library(tripoint::contract ALIAS tripoint_contract)
