"""The register map in the forms that the tools of PLCs and robot controllers read."""
