// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_MAP_BY_PARTITION_H
#define CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_MAP_BY_PARTITION_H

#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/Plane_border.h>
#include <CGAL/Simple_manifolds/correspondence/internal/mesh/map_mesh.h>
#include <CGAL/Simple_manifolds/correspondence/map_to_canonical_surface.h>
#include <CGAL/Simple_manifolds/paper/map/equalize_tiles.h>
#include <CGAL/Simple_manifolds/paper/map/internal/simplification.h>
#include <CGAL/Simple_manifolds/paper/map/internal/working_mesh.h>
#include <CGAL/Simple_manifolds/paper/map/plane_partition.h>
#include <CGAL/Simple_manifolds/paper/map/sphere_partition.h>
#include <CGAL/Simple_manifolds/paper/map/torus_partition.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsPaper
///
/// How `map_by_partition()` came to its result, or how far: the tiles of a partition that failed can be
/// drawn, too.
struct Partition_report {
  /// The mesh that was cut into tiles: the input, subdivided or simplified.
  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> faces;      ///< of that mesh
  std::vector<int> tile;            ///< per face; -1 or a region where the partition failed
  int attempts = 0;                 ///< the last one has succeeded, or its error was thrown
  int subdivisions = 0;             ///< of the input, in the last attempt
  std::size_t removed_vertices = 0; ///< by simplification, in the last attempt
  Equalization_report equalization; ///< sphere and torus
};

namespace internal {

// The steps of a map by partition, each on the mesh that the one before left.
template <class Atlas>
class Partition_mapper {
public:
  using Point = typename Atlas::Domain_point;
  static constexpr int most_vertices = 3000; // Grimm 2002, section 5.1: meshes of 400 to 3000 vertices suit

  Partition_mapper(const Mesh_arrays& arrays, Projection_weights weights, Partition_report& report)
    : arrays_(arrays), points_(arrays.points), triangles_(arrays.triangles),
      number_of_virtual_faces_(arrays.number_of_virtual_faces), input_(arrays.input), weights_(weights),
      report_(report)
  {
  }

  template <class Visitor>
  Manifold_map<Atlas> run(Visitor& visitor)
  {
    visitor.start_phase("partition");
    if constexpr (Atlas::is_closed)
      partition_closed_mesh();
    else
      partition_disk();
    visitor.end_phase();
    visitor.start_phase("certify");
    Manifold_map<Atlas> map(std::move(points_), std::move(triangles_), std::move(domain_points_),
                            arrays_.number_of_input_vertices, number_of_virtual_faces_, input_);
    visitor.end_phase();
    return map;
  }

private:
  // Where simplified meshes fail, finer ones may do, and where the input fails, subdivided ones.
  void partition_closed_mesh()
  {
    constexpr int most_subdivisions = 3;
    const int n = static_cast<int>(points_.size());
    require_no_hubs();
    for (int target = most_vertices;; target *= 2) {
      try {
        ++report_.attempts;
        attempt((std::min)(n, target));
        break;
      } catch (const Partition_error&) {
        if (target < n) continue;
        if (report_.subdivisions == most_subdivisions || 4 * points_.size() > 10 * most_vertices) throw;
        subdivide(points_, triangles_);
        ++report_.subdivisions;
        target = static_cast<int>(points_.size());
      }
    }
    drop_subdivision();
  }

  // A collapse beside a hub takes time in proportion to its valence, and there are as many.
  void require_no_hubs() const
  {
    std::vector<int> valence(points_.size(), 0);
    for (const Triangle& t : triangles_)
      for (const int v : t) ++valence[v];
    const auto hub = std::max_element(valence.begin(), valence.end());
    if (*hub > largest_valence)
      throw Partition_error(Partition_step::DISKS, "vertex " + std::to_string(hub - valence.begin()) +
                                                     " has valence " + std::to_string(*hub) + ", at most " +
                                                     std::to_string(largest_valence) + " is supported");
  }
  static constexpr int largest_valence = 2000;

  // With at most `number_of_vertices` of the input's vertices, or with all of the subdivided mesh.
  void attempt(int number_of_vertices)
  {
    Working_mesh mesh = working_mesh(points_, triangles_);
    std::vector<Removed_vertex> removed;
    std::vector<int> index;
    if (number_of_vertices < static_cast<int>(points_.size()) && report_.subdivisions == 0)
      std::tie(removed, index) = simplify(mesh, number_of_vertices);
    report_.removed_vertices = removed.size();
    const auto tile = get(CGAL::dynamic_face_property_t<int>(), mesh);
    std::vector<Point> points(num_vertices(mesh));
    const auto domain_point = CGAL::make_property_map(points);
    const Drawing drawing{*this, mesh, tile};
    Tile_partition<Working_mesh> partition;
    partition = partition_of_closed_mesh(atlas_, mesh, tile);
    project_tiles(atlas_, mesh, partition, tile, domain_point, weights_);
    report_.equalization = equalize_tiles(atlas_, mesh, domain_point, weights_);

    if (removed.empty()) {
      domain_points_ = std::move(points);
      return;
    }
    domain_points_.resize(points_.size());
    for (std::size_t v = 0; v < points.size(); ++v) domain_points_[index[v]] = points[v];
    put_back(atlas_, removed, domain_points_);
    adjust_centroids(atlas_, working_mesh(points_, triangles_), CGAL::make_property_map(domain_points_), 10);
  }

  // Keeps the tiles of the mesh for the report, whatever happens.
  template <class FaceTileMap>
  struct Drawing {
    const Partition_mapper& mapper;
    const Working_mesh& mesh;
    FaceTileMap tile;
    ~Drawing()
    {
      Partition_report& r = mapper.report_;
      r.points.clear();
      r.faces.clear();
      r.tile.clear();
      for (const auto v : mesh.vertices())
        r.points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
      for (const auto f : mesh.faces()) {
        const auto h = mesh.halfedge(f);
        r.faces.push_back({static_cast<int>(mesh.source(h)), static_cast<int>(mesh.target(h)),
                           static_cast<int>(mesh.target(mesh.next(h)))});
        r.tile.push_back(get(tile, f));
      }
    }
  };
  template <class FaceTileMap>
  Drawing(const Partition_mapper&, const Working_mesh&, FaceTileMap) -> Drawing<FaceTileMap>;

  // The vertices of a subdivision are not needed where the faces of the input are positive without them.
  void drop_subdivision()
  {
    if (report_.subdivisions == 0) return;
    const auto is_positive = [&](const Triangle& t) {
      return is_face_positive(atlas_, domain_points_[t[0]], domain_points_[t[1]], domain_points_[t[2]]);
    };
    if (!std::all_of(arrays_.triangles.begin(), arrays_.triangles.end(), is_positive)) {
      const std::size_t parts = triangles_.size() / arrays_.triangles.size(); // of each face, side by side
      number_of_virtual_faces_ = parts * arrays_.number_of_virtual_faces;
      std::vector<int> parents;
      for (std::size_t f = 0; f + number_of_virtual_faces_ < triangles_.size(); ++f)
        parents.push_back(static_cast<int>(f / parts));
      input_ = arrays_.input.of_parts(std::move(parents));
      return;
    }
    points_ = arrays_.points;
    triangles_ = arrays_.triangles;
    domain_points_.resize(points_.size());
  }

  // Grimm 2002, section 5.3. Edges that would lie on a side of the square are split.
  void partition_disk()
  {
    report_.attempts = 1;
    std::vector<int> corners;
    {
      const Working_mesh mesh = working_mesh(points_, triangles_);
      const auto border = disk_border(mesh, get(CGAL::dynamic_face_property_t<int>(), mesh));
      if (border.size() >= 4)
        for (const auto v : evenly_spaced(source_vertices(mesh, border), 4))
          corners.push_back(static_cast<int>(v));
    }
    const Plane_border disk(points_, triangles_, corners);
    points_ = disk.points();
    triangles_ = disk.triangles();
    std::vector<int> parents = disk.parents();
    parents.resize(parents.size() - number_of_virtual_faces_); // inside of the disk, and never split
    input_ = arrays_.input.of_parts(std::move(parents));

    const Working_mesh mesh = working_mesh(points_, triangles_);
    const auto tile = get(CGAL::dynamic_face_property_t<int>(), mesh);
    const Drawing drawing{*this, mesh, tile};
    const auto border = disk_border(mesh, tile);
    std::vector<Working_mesh::Vertex_index> corner_vertices;
    for (const auto v : source_vertices(mesh, border)) {
      const unsigned sides = disk.sides()[v];
      if ((sides & (sides - 1)) != 0) // two bits
        corner_vertices.push_back(v);
    }
    domain_points_.resize(points_.size());
    project_tiles(atlas_, mesh, plane_partition(mesh, border, corner_vertices), tile,
                  CGAL::make_property_map(domain_points_), weights_);
  }

  Atlas atlas_;
  const Mesh_arrays& arrays_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Triangle> triangles_;
  std::vector<Point> domain_points_;
  std::size_t number_of_virtual_faces_;
  Input_indices input_;
  Projection_weights weights_;
  Partition_report& report_;
};

// Whether there is a partition for an atlas: into one tile, or by partition_of_closed_mesh().
template <class Atlas, class = void>
inline constexpr bool has_partition = Atlas::has_single_chart;
template <class Atlas>
inline constexpr bool
  has_partition<Atlas, std::void_t<decltype(partition_of_closed_mesh(
                         std::declval<const Atlas&>(), std::declval<const Working_mesh&>(), 0))>> = true;

template <class NamedParameters>
Any_map map_by_partition(const Mesh_arrays& arrays, const NamedParameters& np)
{
  Default_visitor default_visitor;
  auto& visitor = parameter(np, CGAL::internal_np::visitor, default_visitor);
  Partition_report own_report;
  Partition_report& report = parameter(np, internal_np::partition_report, own_report);
  report = Partition_report();
  const Projection_weights weights =
    parameter(np, internal_np::projection_weights, Projection_weights::CENTROID);

  return with_canonical_surface(arrays.topology, [&](auto type) -> Any_map {
    using Atlas = typename decltype(type)::Atlas;
    if constexpr (has_partition<Atlas>)
      return Partition_mapper<Atlas>(arrays, weights, report).run(visitor);
    else
      throw Topology_error(Error_code::wrong_genus,
                           arrays.topology.sentence() + ": the paper has partitions for genus 0 and 1 only");
  });
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsPaper
///
/// Maps a mesh to the canonical surface of its genus as Grimm 2002, section 5, does: the mesh is cut into
/// disks, one for each tile, the disks are projected onto the tiles, and the whole is evened out. Meshes of
/// more than 3,000 vertices are simplified first and their vertices put back at the end; when the partition
/// fails, it is tried with a finer mesh, at last with a subdivision.
///
/// The result is certified, as every map. But a map need not be found: then the error says at which step, and
/// why. The functions `map_to_sphere()`, `map_to_torus()` and `map_to_plane()` do not fail, and their maps
/// have less distortion.
///
/// \tparam FaceListGraph  a model of `FaceListGraph`; faces may be polygons, and are cut into triangles then
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map} \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{model of `ReadablePropertyMap`: vertex to `Point_3`}
///     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, mesh)`} \cgalParamNEnd
///   \cgalParamNBegin{close_borders} \cgalParamDescription{the border loops to close virtually}
///     \cgalParamType{`Close_borders`} \cgalParamDefault{`Close_borders::NONE`} \cgalParamNEnd
///   \cgalParamNBegin{projection_weights} \cgalParamDescription{the weights of neighbours}
///     \cgalParamType{`Projection_weights`} \cgalParamDefault{`Projection_weights::CENTROID`} \cgalParamNEnd
///   \cgalParamNBegin{partition_report} \cgalParamDescription{what happened, filled even when the partition
///     fails} \cgalParamType{`Partition_report`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{visitor} \cgalParamDescription{progress and cancel} \cgalParamType{model of
///     `SimpleManifoldsVisitor`, by `std::ref()`} \cgalParamDefault{none} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throw Topology_error, Geometry_error  as `map_to_canonical_surface()`
/// \throw Partition_error  when a step fails, or a vertex of a closed mesh has more than 2000 neighbours
/// \throw Numeric_error  when the result is not one to one, or double precision does not suffice
template <class FaceListGraph, class NamedParameters = parameters::Default_named_parameters>
Any_mesh_map<FaceListGraph> map_by_partition(const FaceListGraph& mesh,
                                             const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_MESH(FaceListGraph);
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(
    NamedParameters, "vertex_point_map, close_borders, projection_weights, partition_report, visitor");
  CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, partition_report);
  CGAL_SIMPLE_MANIFOLDS_REQUIRE_VISITOR(internal::Visitor_of<NamedParameters>);
  auto [vertex, arrays] = internal::numbered_mesh(mesh, np);
  Any_map map = internal::map_by_partition(arrays, np);
  return internal::with_mesh(
    std::move(map), std::make_shared<const internal::Mesh_elements<FaceListGraph>>(mesh, std::move(vertex)));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_PAPER_MAP_MAP_BY_PARTITION_H
