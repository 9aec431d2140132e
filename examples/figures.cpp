#include "figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace tools {

std::string shown(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

// Beside the other: in a namespace of its own it would hide that, and call itself.
std::string shown(const Json& x) { return x.is_number() ? shown(x.get<double>()) : "infinite"; }

namespace {

// A fraction of the diagonal: "0.15 %".
std::string percent(const Json& x)
{
  return x.is_number() ? shown(100 * x.get<double>()) + " %" : "infinite";
}

std::string count(const Json& n, const char* of = "")
{
  return std::to_string(n.get<long long>()) + (*of == 0 ? "" : " ") + of;
}

constexpr std::size_t largest_table = 12; // rows

// Rows with aligned columns.
std::string aligned(const std::vector<std::vector<std::string>>& table)
{
  std::string text;
  for (const std::vector<std::string>& row : table) {
    text += ' ';
    for (const std::string& cell : row)
      text += std::string(10 - (std::min)(cell.size(), std::size_t(9)), ' ') + cell;
    text += '\n';
  }
  return text;
}

// The lines and the table.
class Figures {
public:
  explicit Figures(const Json& metrics) : metrics_(metrics), map_(metrics.value("map", Json()))
  {
    if (metrics_.contains("parts")) {
      add_parts();
      return;
    }
    add_input();
    if (metrics_.contains("surface")) add_surface(metrics_["surface"]);
    add_resources();
    add_charts();
  }

  const std::string& text() const { return text_; }

private:
  void line(const std::string& name, const std::string& value)
  {
    text_ += "  " + name + std::string(18 - (std::min)(name.size(), std::size_t(16)), ' ') + value + '\n';
  }

  void add_input()
  {
    const Json& input = metrics_["input"];
    const int loops = input["border_loops"];
    text_ += input["file"].get<std::string>() + '\n';
    line("mesh", count(map_["vertices"], "vertices") + ", " + count(map_["faces"], "faces") + ", " +
                   (loops == 0 ? "closed" : count(loops, loops == 1 ? "border" : "borders")) + ", genus " +
                   count(input["genus"]) + (input["inward_oriented"] ? ", inward oriented" : ""));
    add_reading(input);
    if (input.contains("components")) line("body", "the largest of " + count(input["components"]));
    if (const int unused = input["isolated_vertices"]; unused > 0)
      line("left out", count(unused, unused == 1 ? "vertex" : "vertices") + " of no face");
    line("map", "onto the " + map_["atlas"].get<std::string>() + ", one to one by proof: " +
                  count(map_["flipped"]) + " faces flipped, degree " + shown(map_["degree"]));
    line("angle distortion", shown(map_["angle"]) + " on average, 1 is conformal");
    line("area distortion",
         (map_["area"].is_number() ? shown(std::pow(10, map_["area"].get<double>())) : "infinite") +
           " on average, 1 keeps areas");
  }

  // The bodies of a file: one row each, and totals.
  void add_parts()
  {
    const Json &input = metrics_["input"], &totals = metrics_["totals"], &parts = metrics_["parts"];
    const bool has_surfaces = totals.contains("controls");
    text_ += input["file"].get<std::string>() + '\n';
    line("mesh", count(input["components"], "bodies, ") + count(input["vertices"], "vertices, ") +
                   count(input["faces"], "faces"));
    add_reading(input);
    line("served", count(totals["served"]) + " of " + count(totals["parts"], "bodies"));
    add_resources();
    std::vector<std::vector<std::string>> table = {{"body", "faces", "genus", "borders", "map"}};
    if (has_surfaces)
      for (const char* head : {"controls", "rms error", "largest"}) table[0].push_back(head);
    for (std::size_t k = 0; k < parts.size() && k < largest_table; ++k) {
      const Json& part = parts[k];
      std::vector<std::string> row = {part["name"].get<std::string>(), count(part["faces"])};
      if (part.contains("error")) {
        for (const char* cell : {"-", "-", "none"}) row.push_back(cell);
      } else {
        const Json& own = part["input"];
        row.insert(row.end(), {count(own["genus"]), count(own["border_loops"]),
                               part["map"]["atlas"].get<std::string>()});
        if (has_surfaces) {
          const Json& s = part["surface"];
          row.insert(row.end(), {count(s["controls"]), percent(s["rms_error"]), percent(s["max_error"])});
        }
      }
      table.push_back(row);
    }
    text_ += aligned(table);
    if (parts.size() > largest_table)
      text_ += "  and " + std::to_string(parts.size() - largest_table) + " more bodies\n";
  }

  // What was done to the file's mesh, and what else the file has.
  void add_reading(const Json& input)
  {
    if (metrics_.contains("repair") && metrics_["repair"].contains("sentence"))
      line("repaired", metrics_["repair"]["sentence"]);
    if (metrics_.contains("reshape"))
      line("reshaped", "flat parts have small triangles now: " + count(metrics_["reshape"]["faces_before"]) +
                         " to " + count(metrics_["reshape"]["faces"], "faces"));
    for (const auto& [name, value] : lines_of_reading(input)) line(name, value);
  }

  void add_surface(const Json& s)
  {
    const Json& p = metrics_["parameters"];
    line("surface", "C" + count(s["smoothness"]) + ", degree " + count(p["degree"]) + ", " +
                      count(s["controls"], "controls"));
    std::string rms, max; // the tolerances of the errors that they refer to
    if (p["surface"] == "patches") {
      double average = 0, largest = 0;
      for (const Json& c : s["charts"]) {
        average = (std::max)(average, c["average_delta"].get<double>());
        largest = (std::max)(largest, c["max_delta"].get<double>());
      }
      line("weighted error",
           percent(average) + " of the diagonal on average in the worst chart" + tolerance(p["tolerance"]));
      line("largest of them", percent(largest) + " of the diagonal" + tolerance(p["max_tolerance"]));
    } else if (p["marking"] == "vertices") {
      line("at vertices", percent(s["vertex_rms_error"]) + " of the diagonal rms" +
                            tolerance(p["tolerance"]) + ", at most " + percent(s["vertex_max_error"]) +
                            tolerance(p["max_tolerance"]));
    } else {
      rms = tolerance(p["tolerance"]);
      max = tolerance(p["max_tolerance"]);
    }
    line("rms error", percent(s["rms_error"]) + " of the diagonal" + rms);
    line("largest error", percent(s["max_error"]) + " of the diagonal" + max);
    line("distance", percent(s["closest_point_rms"]) + " of the diagonal rms, at most " +
                       percent(s["closest_point_max"]) + ", from mesh to surface");
    if (s.contains("target_max") && s["target_max"].get<double>() > 0)
      line("target", percent(s["target_max"]) + " of the diagonal at most from the facets");
    if (metrics_.contains("written")) {
      const Json& w = metrics_["written"];
      const double largest =
        (std::max)(w["mesh_to_surface"]["max"].get<double>(), w["surface_to_mesh"]["max"].get<double>());
      line("surface.ply", percent(largest) + " of the diagonal at most from the mesh, " +
                            percent(w["chord_error"]) + " from the surface");
      const Json& turning = w["turning_edges"];
      if (turning["surface"] > turning["mesh"])
        line("turns over", "at " + count(turning["surface"], "edges of surface.ply") +
                             " by more than 120 degrees, " + count(turning["mesh"], "of the mesh"));
    }
    if (s.contains("folds") && s["folds"] > 0) line("folds", "at " + count(s["folds"], "faces of the mesh"));
    line("normals", shown(s["normal_deviation"].get<double>() * 180 / 3.14159265358979324) +
                      " degrees rms from those of the faces");
  }

  void add_resources()
  {
    const Json& t = metrics_["seconds"];
    const bool has_fit = t.contains("fit");
    const double work = t["map"].get<double>() + (has_fit ? t["fit"].get<double>() : 0.);
    line("time",
         shown(work) + (has_fit ? " s to map and fit, " : " s to map, ") + shown(t["total"]) + " s in all");
    line("memory", shown(metrics_["peak_memory_bytes"].get<double>() / 1e6) + " MB at most");
  }

  void add_charts()
  {
    const Json& vertices = map_["chart_counts"];
    std::vector<std::vector<std::string>> table = {{"chart", "vertices"}};
    const bool has_surface = metrics_.contains("surface");
    if (has_surface) {
      const bool is_patches = metrics_["parameters"]["surface"] == "patches";
      for (const char* head : {"controls", is_patches ? "patches" : "levels", "rms error", "largest"})
        table[0].push_back(head);
    }
    for (std::size_t c = 0; c < vertices.size() && c < largest_table; ++c) {
      std::vector<std::string> row = {std::to_string(c), count(vertices[c])};
      if (has_surface) {
        const Json& chart = metrics_["surface"]["charts"][c];
        for (const std::string& value : {count(chart["controls"]), count(chart["levels"]),
                                         percent(chart["rms_error"]), percent(chart["max_error"])})
          row.push_back(value);
      }
      table.push_back(row);
    }
    text_ += aligned(table);
    if (vertices.size() > largest_table)
      text_ += "  and " + std::to_string(vertices.size() - largest_table) + " more charts\n";
  }

  static std::string tolerance(const Json& x) { return " (tolerance " + percent(x) + ")"; }

  const Json& metrics_;
  const Json map_;
  std::string text_;
};

} // namespace

std::vector<std::pair<std::string, std::string>> lines_of_reading(const Json& reading)
{
  std::vector<std::pair<std::string, std::string>> lines;
  if (const std::string unit = reading["unit"]; !unit.empty())
    lines.emplace_back("unit", unit + " in the file, not converted");
  for (const Json& warning : reading["warnings"]) lines.emplace_back("warning", warning["sentence"]);
  std::string kept, dropped;
  const auto add = [](std::string& to, const Json& name) {
    to += (to.empty() ? "" : ", ") + name.get<std::string>();
  };
  for (const char* list : {"vertex_properties", "face_properties"})
    for (const Json& name : reading[list]) add(kept, name);
  for (const Json& property : reading["dropped_properties"]) add(dropped, property["name"]);
  if (!kept.empty()) lines.emplace_back("properties", kept);
  if (!dropped.empty())
    lines.emplace_back("dropped", dropped + ": neither vertices nor faces have a value of it each");
  return lines;
}

std::string figures(const Json& metrics) { return Figures(metrics).text(); }

} // namespace tools
