// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_REPORT_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_REPORT_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/chart_colour.h>
#include <CGAL/Simple_manifolds/IO/internal/report/Report_arrays.h>
#include <CGAL/Simple_manifolds/IO/internal/report/Report_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/report/control_cells.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// Collects what a report shows, and writes it into the page.
template <class Map>
class Report_writer {
public:
  static constexpr std::size_t max_faces = 100000;

  Report_writer(const Map& map, const nlohmann::ordered_json& figures)
    : map_(map), distortions_(face_distortions(map)), mesh_(report_mesh(map, distortions_, max_faces))
  {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : map.points()) box.extend(p);
    centre_ = box.center();
    info_ = {{"faces", mesh_.angle.size()}, {"faces_of_map", distortions_.angle.size()},
             {"diagonal", unit()},          {"centre", {centre_.x(), centre_.y(), centre_.z()}},
             {"figures", figures},          {"atlas", facts_of_atlas(map.atlas())}};
  }

  template <class Surface>
  void add_surface(const Surface& surface, const Fit_report& report)
  {
    const int subdivisions = Tile_grid<typename Map::Atlas>::subdivisions_for(
      std::clamp(double(map_.number_of_vertices()), 10000., 40000.), map_.atlas());
    auto tessellation = report_tessellation(map_, surface, subdivisions, distortions_);
    tessellation.evaluate(map_, surface);
    tessellation.add_to(arrays_, "surface", map_.atlas(), centre_, unit());
    mesh_.evaluate(map_, surface);

    std::vector<int> charts;
    std::vector<Eigen::Vector3d> corners = control_cells(surface, charts);
    for (Eigen::Vector3d& p : corners) p = (p - centre_) / unit();
    arrays_.add_vectors("net.points", corners, 14);
    arrays_.add_integers("net.charts", charts);

    nlohmann::ordered_json fit = {{"rms_tolerance", report.rms_tolerance},
                                  {"max_tolerance", report.max_tolerance}};
    for (const Fit_report::Chart& c : report.charts)
      fit["charts"].push_back({{"controls", c.controls}, {"rms", c.rms_error}, {"max", c.max_error}});
    for (const Fit_report::Level& l : report.levels)
      fit["levels"].push_back({{"controls", l.controls}, {"rms", l.rms_error}, {"max", l.max_error}});
    info_["fit"] = std::move(fit);
  }

  void write(const std::string& file, std::string_view page)
  {
    mesh_.add_to(arrays_, "mesh", map_.atlas(), centre_, unit());
    info_["arrays"] = arrays_.table();
    std::string info = info_.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    for (std::size_t i = info.find('<'); i != std::string::npos; i = info.find('<', i))
      info.replace(i, 1, "\\u003c"); // nothing in it may end the script element
    const std::string_view mark = "<!-- data -->";
    const std::size_t at = page.find(mark);
    if (at == std::string_view::npos)
      throw IO_error(Error_code::cannot_write, file, "the page has no place for the data");
    Atomic_file output(file);
    output.stream() << page.substr(0, at) << "<script id=\"info\" type=\"application/json\">" << info
                    << "</script>\n"
                    << "<script id=\"arrays\" type=\"application/octet-stream\">" << arrays_.text()
                    << "</script>" << page.substr(at + mark.size());
    output.commit();
  }

private:
  // All that the page has to know of a canonical surface.
  template <class Atlas>
  static nlohmann::ordered_json facts_of_atlas(const Atlas& atlas)
  {
    nlohmann::ordered_json facts = {
      {"name", atlas.name}, {"genus", atlas.genus()}, {"is_closed", atlas.is_closed}};
    for (int c = 0; c < atlas.number_of_charts(); ++c) {
      const Eigen::Vector3d colour = 255 * chart_colour(c);
      char text[8];
      std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned(std::lround(colour[0])) & 255,
                    unsigned(std::lround(colour[1])) & 255, unsigned(std::lround(colour[2])) & 255);
      facts["charts"].push_back({{"colour", text}});
    }
    for (const Domain_shape<Atlas>& shape : domain_shapes(atlas))
      facts["shapes"].push_back({{"title", shape.title}, {"is_flat", shape.is_flat}});
    return facts;
  }

  double unit() const { return map_.diagonal() > 0 ? map_.diagonal() : 1; }

  const Map& map_;
  Face_distortions distortions_;
  Report_mesh<typename Map::Atlas> mesh_;
  Eigen::Vector3d centre_;
  nlohmann::ordered_json info_;
  Report_arrays arrays_;
};

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a page that shows a map in a browser: the mesh beside its canonical surface, coloured by chart, by
/// chart coordinates or by distortion, and the figures as a table. The page is one file that needs nothing
/// else, neither other files nor a network. Of meshes with more than 100,000 faces it shows a simplification.
///
/// \param figures  what the page lists as a table: groups of named values, as in `metrics.json` of `fit_mesh`
/// \param page  the page without its data: `simple_manifolds_report_page`, in the header
///   `simple_manifolds_report_page.h` that the CMake target `CGAL::Simple_manifolds_report` provides
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class Map>
void write_report(const std::string& file, const Map& map, const nlohmann::ordered_json& figures,
                  std::string_view page)
{
  internal::Report_writer<internal::Map_on_arrays<Map>>(map, figures).write(file, page);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with a surface that was fitted to the map: a third panel shows it, and the fit error, its
/// curvatures and its control nets can be shown.
/// \param report  of the fit
template <class Map, class Surface>
void write_report(const std::string& file, const Map& map, const Surface& surface, const Fit_report& report,
                  const nlohmann::ordered_json& figures, std::string_view page)
{
  internal::Report_writer<internal::Map_on_arrays<Map>> writer(map, figures);
  writer.add_surface(surface, report);
  writer.write(file, page);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_REPORT_H
