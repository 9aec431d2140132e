// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_PART_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_PART_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/chart_colour.h>
#include <CGAL/Simple_manifolds/IO/internal/report/Report_arrays.h>
#include <CGAL/Simple_manifolds/IO/internal/report/Report_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/report/control_cells.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Domain_shape.h>
#include <CGAL/Simple_manifolds/cad/Cad_tessellation.h>
#include <CGAL/Simple_manifolds/cad/cad_domain_point.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/Jet_geometry.h>
#include <CGAL/Simple_manifolds/tessellation/Domain_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/Tile_grid.h>
#include <CGAL/Simple_manifolds/tessellation/refine_triangulation.h>
#include <CGAL/Simple_manifolds/tessellation/sizing.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Collects what a report shows of a map, and of the surface that was fitted to it.
template <class Map>
class Report_part {
public:
  // `share`: of what a page shows of the mesh and of the surface at most, so that pages of many parts are not larger.
  Report_part(const Map& map, const nlohmann::ordered_json& figures, double share = 1)
    : map_(map), share_(share), distortions_(face_distortions(map)),
      mesh_(
        report_mesh(map, distortions_, (std::max)(least_faces, static_cast<std::size_t>(share * most_faces))))
  {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : map.points()) box.extend(p);
    centre_ = box.center();
    info_ = {{"faces", mesh_.angle.size()}, {"faces_of_map", distortions_.angle.size()},
             {"diagonal", unit()},          {"centre", {centre_.x(), centre_.y(), centre_.z()}},
             {"figures", figures},          {"atlas", facts_of_atlas(map.atlas())}};
  }

  // Its arrays get names that begin with `prefix`.
  template <class Surface>
  void add_surface(const Surface& surface, const Fit_report& report, Report_arrays& arrays,
                   const std::string& prefix = "")
  {
    using Grid = Tile_grid<typename Map::Atlas>;
    Domain_triangulation<typename Map::Atlas> triangulation(
      Grid(Grid::subdivisions_for(share_ * std::clamp(double(map_.number_of_vertices()) / 2, 5000., 20000.),
                                  map_.atlas()),
           Tile_borders::EXACT, map_.atlas()));
    const double chord_error = report.rms_tolerance > 0 ? report.rms_tolerance / 2 : 1e-3;
    const Tessellation_report fineness =
      refine_triangulation(triangulation, Chord_error<Surface>(surface, chord_error, unit()),
                           static_cast<std::size_t>(share_ * most_faces));
    auto tessellation = report_tessellation(map_, surface, triangulation, distortions_);
    tessellation.evaluate(map_, surface);
    tessellation.add_to(arrays, prefix + "surface", map_.atlas(), centre_, unit());
    mesh_.evaluate(map_, surface);

    std::vector<int> charts;
    std::vector<Eigen::Vector3d> corners = control_cells(surface, charts);
    for (Eigen::Vector3d& p : corners) p = (p - centre_) / unit();
    arrays.add_vectors(prefix + "net.points", corners, 14);
    arrays.add_integers(prefix + "net.charts", charts);

    nlohmann::ordered_json fit = {{"rms_tolerance", report.rms_tolerance},
                                  {"max_tolerance", report.max_tolerance},
                                  {"chord_error", fineness.worst * chord_error},
                                  {"folds", report.folds},
                                  {"places", places_of(report)}};
    for (const Fit_report::Chart& c : report.charts)
      fit["charts"].push_back({{"controls", c.controls}, {"rms", c.rms_error}, {"max", c.max_error}});
    for (const Fit_report::Level& l : report.levels)
      fit["levels"].push_back({{"controls", l.controls}, {"rms", l.rms_error}, {"max", l.max_error}});
    info_["fit"] = std::move(fit);
  }

  // The faces of a CAD surface, with their borders.
  void add_cad(const Cad_surface& surface, Report_arrays& arrays, const std::string& prefix = "")
  {
    constexpr double enough = 30000;
    int cells = 16; // per span
    Cad_tessellation tessellation = cad_tessellation(surface, cells);
    while (cells > 1 && double(tessellation.triangles.size()) > share_ * enough)
      tessellation = cad_tessellation(surface, cells /= 2);

    Report_mesh<typename Map::Atlas> mesh;
    std::vector<int> numbers;
    Vertex_copies<int> vertices;
    for (const std::array<int, 3>& t : tessellation.triangles) {
      const int number = tessellation.vertices[t[0]].face;
      const Cad_face& face = surface.faces()[number];
      const auto uv = [&](int k) { return tessellation.vertices[t[k]].uv; };
      const int tile = map_.atlas().tile(cad_domain_point(map_.atlas(), face, (uv(0) + uv(1) + uv(2)) / 3));
      Triangle triangle;
      for (int k = 0; k < 3; ++k)
        triangle[k] = vertices.find(t[k], tile, [&] {
          mesh.normals.push_back(normal(face.jet(uv(k))));
          return mesh.add_vertex(map_.atlas(), tile, cad_domain_point(map_.atlas(), face, uv(k)),
                                 tessellation.points[tessellation.vertices[t[k]].point]);
        });
      mesh.triangles.push_back(triangle);
      numbers.push_back(number);
    }
    std::vector<Eigen::Vector3d> borders; // both ends of each segment
    for (const std::vector<int>& edge : tessellation.edges)
      for (std::size_t k = 0; k + 1 < edge.size(); ++k)
        for (const int point : {edge[k], edge[k + 1]})
          borders.push_back((tessellation.points[point] - centre_) / unit());
    mesh.add_to(arrays, prefix + "cad", map_.atlas(), centre_, unit());
    arrays.add_integers(prefix + "cad.numbers", numbers);
    arrays.add_vectors(prefix + "cad.borders", borders, 14);
  }

  // All that is known of it, after its mesh was added to the arrays.
  nlohmann::ordered_json add_mesh(Report_arrays& arrays, const std::string& prefix = "")
  {
    mesh_.add_to(arrays, prefix + "mesh", map_.atlas(), centre_, unit());
    return std::move(info_);
  }

private:
  static constexpr std::size_t most_faces = 100000, least_faces = 500;

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

  // Where to look: where the error is largest, and where the surface turns over.
  nlohmann::ordered_json places_of(const Fit_report& report) const
  {
    nlohmann::ordered_json places = nlohmann::ordered_json::array();
    const auto add = [&](const char* kind, const typename Map::Domain_point& p) {
      const int tile = map_.atlas().tile(p);
      const Eigen::Vector2d uv = map_.atlas().coordinates(tile, p);
      places.push_back({{"kind", kind}, {"chart", tile}, {"uv", {uv[0], uv[1]}}});
    };
    if (report.max_error > 0) add("worst", domain_point_of(report.worst_point));
    for (const Fit_report::Fold& fold : report.fold_places)
      add("fold", centre_of(map_.atlas(), map_.domain_points(), map_.face(fold.face)));
    return places;
  }

  // Of the place that is nearest to x among those where errors are measured.
  typename Map::Domain_point domain_point_of(const Eigen::Vector3d& x) const
  {
    typename Map::Domain_point found = map_.domain_point(0);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < distortions_.angle.size(); ++f)
      for (const double largest : {1., 2. / 3})
        for (int k = 0; k < 3; ++k) {
          Eigen::Vector3d b = Eigen::Vector3d::Constant((1 - largest) / 2);
          b[k] = largest;
          const Triangle& t = map_.face(f);
          const double d =
            (b[0] * map_.point(t[0]) + b[1] * map_.point(t[1]) + b[2] * map_.point(t[2]) - x).squaredNorm();
          if (!(d < least)) continue;
          least = d;
          found = map_.atlas().interpolate(map_.domain_point(t[0]), map_.domain_point(t[1]),
                                           map_.domain_point(t[2]), b);
        }
    return found;
  }

  double unit() const { return map_.diagonal() > 0 ? map_.diagonal() : 1; }

  const Map& map_;
  double share_;
  Face_distortions distortions_;
  Report_mesh<typename Map::Atlas> mesh_;
  Eigen::Vector3d centre_;
  nlohmann::ordered_json info_;
};

// Writes a page with its data.
inline void write_report_page(const std::string& file, std::string_view page, nlohmann::ordered_json info,
                              const Report_arrays& arrays)
{
  info["arrays"] = arrays.table();
  std::string text = info.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i))
    text.replace(i, 1, "\\u003c"); // nothing in it may end the script element
  const std::string_view mark = "<!-- data -->";
  const std::size_t at = page.find(mark);
  if (at == std::string_view::npos)
    throw IO_error(Error_code::cannot_write, file, "the page has no place for the data");
  Atomic_file output(file);
  output.stream() << page.substr(0, at) << "<script id=\"info\" type=\"application/json\">" << text
                  << "</script>\n"
                  << "<script id=\"arrays\" type=\"application/octet-stream\">" << arrays.text()
                  << "</script>" << page.substr(at + mark.size());
  output.commit();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_PART_H
