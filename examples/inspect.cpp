#include "inspect.h"

#include "program_tools.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/inspect_mesh.h>
#include <CGAL/Simple_manifolds/repair/repair_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <future>
#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tools {

namespace {

// A way to read the file, and what comes of it.
struct Plan {
  bool has_repair; // whether --repair is given
  SM::Repair_report report;
  SM::Mesh_inspection result;
};

Plan plan(const SM::Mesh_soup& soup, SM::Repair_options options, bool has_repair)
{
  Plan p{has_repair, {}, {}};
  p.result = SM::inspect_soup(
    SM::repair_soup(soup, SM::parameters::repair_options(options).repair_report(std::ref(p.report))));
  return p;
}

struct Closing {
  SM::Close_borders which;
  const char* name; // of --close-borders
};
constexpr std::array<Closing, 3> closings = {{{SM::Close_borders::SMALL, "small"},
                                              {SM::Close_borders::INNER, "inner"},
                                              {SM::Close_borders::ALL, "all"}}};

// The options that serve most parts: of equal ones those that do least to the object.
struct Choice {
  const Plan* plan = nullptr;
  Closing closing = closings[0];
  std::size_t served = 0;

  explicit Choice(const std::vector<Plan>& plans) : plan(&plans.front())
  {
    for (const Plan& p : plans) {
      if (!p.report.left.is_empty()) continue; // it is refused as a whole
      for (const Closing& c : closings) {
        const auto n = static_cast<std::size_t>(
          std::count_if(p.result.components.begin(), p.result.components.end(),
                        [&](const auto& part) { return !part.canonical_surface(c.which).empty(); }));
        if (n <= served) continue;
        plan = &p;
        closing = c;
        served = n;
      }
    }
  }

  std::size_t parts() const { return plan->result.components.size(); }
  std::string surface(const SM::Inspected_component& part) const
  {
    const std::string_view name = part.canonical_surface(closing.which);
    return name.empty() ? "none" : std::string(name);
  }
  std::string command(const std::string& file, const Command_line& options) const
  {
    if (served == 0) return std::string();
    const bool is_plain = file.find_first_of(" '\"\\$&;()<>|*?`!#~\t\n") == std::string::npos;
    std::string text = "map_mesh " + (is_plain ? file : '"' + file + '"') + " -o OUT.ply";
    if (plan->has_repair) text += " --repair";
    if (options.has("weld")) text += " --weld " + options.get<std::string>("weld");
    if (closing.which != SM::Close_borders::SMALL) text += std::string(" --close-borders ") + closing.name;
    return text;
  }
};

Json json_of_box(const Eigen::AlignedBox3d& box)
{
  if (box.isEmpty()) return nullptr;
  const auto corner = [](const Eigen::Vector3d& p) { return Json{p.x(), p.y(), p.z()}; };
  return {corner((box.min)()), corner((box.max)())};
}

Json json_of_faults(const SM::Surface_faults& f)
{
  Json json{{"missing_vertices", f.missing_vertices.count},
            {"non_finite_vertices", f.non_finite_vertices.count},
            {"degenerate_faces", f.degenerate_faces.count},
            {"repeated_corners", f.repeated_corners.count},
            {"duplicate_faces", f.duplicate_faces.count},
            {"non_manifold_edges", f.non_manifold_edges.count},
            {"inconsistent_edges", f.inconsistent_edges.count},
            {"non_manifold_vertices", f.non_manifold_vertices.count},
            {"one_sided_components", f.one_sided_components},
            {"coincident_borders", f.coincident_borders.count}};
  if (!f.is_empty()) json["sentence"] = f.sentence();
  return json;
}

Json json_of_part(const SM::Inspected_component& part, const Choice& choice)
{
  Json loops = Json::array();
  for (const SM::Border_loop& l : part.loops)
    loops.push_back({{"edges", l.edges}, {"length", number(l.length)}, {"small", l.is_small}});
  return {{"name", part.name},
          {"first_face", part.first_face},
          {"vertices", part.vertices},
          {"edges", part.edges},
          {"faces", part.faces},
          {"area", number(part.area)},
          {"bounding_box", json_of_box(part.box)},
          {"borders", std::move(loops)},
          {"euler_characteristic", part.euler_characteristic()},
          {"orientable", part.faults.one_sided_components == 0},
          {"genus", part.is_surface() ? Json(part.genus()) : Json(nullptr)},
          {"faults", json_of_faults(part.faults)},
          {"surface", choice.surface(part)}};
}

Json json_of_plan(const Plan& plan, const Choice& choice)
{
  Json parts = Json::array();
  for (const SM::Inspected_component& part : plan.result.components)
    parts.push_back(json_of_part(part, choice));
  return {{"vertices", plan.result.vertices},
          {"edges", plan.result.edges},
          {"faces", plan.result.faces},
          {"area", number(plan.result.area)},
          {"bounding_box", json_of_box(plan.result.box)},
          {"repair", metrics_of_repair(plan.report)},
          {"faults", json_of_faults(plan.report.left)},
          {"parts", std::move(parts)}};
}

// The table.
class Table {
public:
  explicit Table(const Choice& choice) : choice_(choice) {}

  void line(const std::string& name, const std::string& value)
  {
    text_ += "  " + name + std::string(18 - (std::min)(name.size(), std::size_t(16)), ' ') + value + '\n';
  }

  void add(const Plan& plan)
  {
    line(plan.has_repair ? "with --repair" : "read",
         plan.report.has_changes() ? plan.report.sentence() : "nothing to repair");
    if (!plan.report.left.is_empty()) line("left", plan.report.left.sentence());
    const auto& parts = plan.result.components;
    if (parts.empty()) return line("", "no face");
    row({"part", "vertices", "faces", "borders", "length", "genus", "area", "surface"});
    std::map<std::string, std::size_t> others; // parts by surface
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const SM::Inspected_component& part = parts[i];
      if (i >= most_rows) {
        ++others[choice_.surface(part)];
        continue;
      }
      double length = 0;
      for (const SM::Border_loop& l : part.loops) length += l.length;
      row({part.name, std::to_string(part.vertices), std::to_string(part.faces),
           part.loops.empty() ? "closed" : std::to_string(part.loops.size()),
           part.loops.empty() ? "" : shown(length),
           part.is_surface() ? std::to_string(part.genus()) : part.sentence(), shown(part.area),
           choice_.surface(part)});
    }
    for (const auto& [surface, n] : others)
      line("", "and " + std::to_string(n) + " smaller ones: " + surface);
  }

  const std::string& text() const { return text_; }

private:
  static constexpr std::size_t most_rows = 20;

  void row(const std::array<std::string, 8>& cells)
  {
    static constexpr std::array<std::size_t, 8> widths = {10, 10, 10, 9, 10, 20, 10, 8};
    std::string line = "    ";
    for (std::size_t i = 0; i < cells.size(); ++i)
      line += cells[i] + std::string(widths[i] - (std::min)(widths[i] - 1, cells[i].size()), ' ');
    text_ += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }

  const Choice& choice_;
  std::string text_;
};

} // namespace

void add_inspect_options(Command_line& options)
{
  options.add(
    "inspect", po::bool_switch(),
    "print what is in INPUT, part by part, what a repair would do, and the command that serves it;\n"
    "nothing is written");
  options.add("json", po::bool_switch(), "the same as JSON");
}

bool is_inspection(const Command_line& options)
{
  if (options.get<bool>("json") && !options.get<bool>("inspect"))
    throw Usage_error("--json says how --inspect answers");
  return options.get<bool>("inspect");
}

int inspect(const Command_line& options)
{
  const std::string file = options.get<std::string>("input");
  SM::Read_report beside;
  const SM::Mesh_soup soup = SM::read_soup(file, beside);
  const Json reading = metrics_of_reading(beside);
  SM::Repair_options as_read, everything = SM::repair_everything();
  as_read.weld_distance = everything.weld_distance = repair_options(options).weld_distance;
  auto repaired = std::async([&] { return plan(soup, everything, true); });
  std::vector<Plan> plans = {plan(soup, as_read, false)};
  plans.push_back(repaired.get());
  const Choice choice(plans);
  const std::string command = choice.command(file, options);

  if (options.get<bool>("json")) {
    Json json{{"file", file},
              {"vertices", soup.number_of_vertices()},
              {"unused_vertices", plans[0].report.unused_vertices},
              {"faces", soup.number_of_faces()},
              {"read", json_of_plan(plans[0], choice)},
              {"repaired", json_of_plan(plans[1], choice)},
              {"parts", choice.parts()},
              {"served_parts", choice.served},
              {"command", command.empty() ? Json(nullptr) : Json(command)}};
    json.update(reading);
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << std::endl;
    return SUCCESS;
  }
  Table table(choice);
  const std::size_t unused = plans[0].report.unused_vertices;
  table.line("file", std::to_string(soup.number_of_vertices()) + " vertices" +
                       (unused > 0 ? " (" + std::to_string(unused) + " of no face)" : "") + ", " +
                       std::to_string(soup.number_of_faces()) + " faces");
  const Eigen::AlignedBox3d& box = plans[0].result.box;
  if (!box.isEmpty()) {
    const Eigen::Vector3d size = box.sizes(), low = (box.min)();
    table.line("bounding box", shown(size.x()) + " x " + shown(size.y()) + " x " + shown(size.z()) + " at (" +
                                 shown(low.x()) + ", " + shown(low.y()) + ", " + shown(low.z()) + ")");
  }
  for (const auto& [name, value] : lines_of_reading(reading)) table.line(name, value);
  for (const Plan& p : plans)
    if (!p.has_repair || p.report.sentence() != plans[0].report.sentence()) table.add(p);
  if (command.empty())
    table.line("command", "none of its parts has a canonical surface: they are for disks and closed bodies");
  else
    table.line("command", command);
  if (choice.served > 0 && choice.served < choice.parts())
    table.line("", "it serves " + std::to_string(choice.served) + " of " + std::to_string(choice.parts()) +
                     " parts");
  std::cout << file << '\n' << table.text() << std::flush;
  return SUCCESS;
}

} // namespace tools
