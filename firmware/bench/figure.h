// One line of build/bench.json.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace tripoint::bench {

struct Figure {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::optional<double> baseline = {};
  std::optional<double> ratio = {};
  std::string goal = {};  ///< such as ">= 18"; empty: none
  bool reached = true;
};

inline Figure at_least(Figure figure, double limit) {
  char text[32];
  std::snprintf(text, sizeof text, ">= %g", limit);
  figure.goal = text;
  figure.reached = figure.value >= limit;
  return figure;
}

inline Figure at_most(Figure figure, double limit) {
  char text[32];
  std::snprintf(text, sizeof text, "<= %g", limit);
  figure.goal = text;
  figure.reached = figure.value <= limit;
  return figure;
}

inline std::string json_of(const std::optional<double>& value) {
  if (!value) return "null";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", *value);
  return text;
}

/// The list as JSON on stdout.
inline void print(const std::vector<Figure>& figures) {
  std::puts("[");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Figure& f = figures[i];
    std::printf(
        "  {\"name\": \"%s\", \"value\": %s, \"unit\": \"%s\", \"baseline\": %s, \"ratio\": %s, \"goal\": %s, "
        "\"reached\": %s}%s\n",
        f.name.c_str(), json_of(f.value).c_str(), f.unit.c_str(), json_of(f.baseline).c_str(), json_of(f.ratio).c_str(),
        f.goal.empty() ? "null" : ("\"" + f.goal + "\"").c_str(), f.reached ? "true" : "false",
        i + 1 < figures.size() ? "," : "");
  }
  std::puts("]");
}

}  // namespace tripoint::bench
