// The figures of a run of fit_mesh or map_mesh for a person: some lines with units and a table of the charts. All
// of them are in the metrics, which have more.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_FIGURES_H
#define SIMPLE_MANIFOLDS_EXAMPLES_FIGURES_H

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace tools {

using Json = nlohmann::ordered_json;

/// E.g. "0.00123".
std::string shown(double x);

/// The same of a figure of the metrics, which may be none.
std::string shown(const Json& x);

/// What a file has beside its mesh, of the metrics of reading, as lines: their names, and what they say.
std::vector<std::pair<std::string, std::string>> lines_of_reading(const Json& reading);

/// The lines and the table.
std::string figures(const Json& metrics);

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_FIGURES_H
