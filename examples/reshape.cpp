#include "reshape.h"

#include <CGAL/Simple_manifolds/repair/reshape_flat_parts.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace tools {

namespace {

// Those of a mesh at the vertices and faces of another one of the same shape.
SM::Mesh_properties properties_at(const Mesh& reshaped, const Mesh& mesh,
                                  const SM::Mesh_properties& properties)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  SM::Mesh_properties result;
  result.dropped = properties.dropped;
  if (properties.empty()) return result;
  using Kernel = CGAL::Simple_cartesian<double>;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>> tree;
  PMP::build_AABB_tree(mesh, tree);
  const auto empty = [](const SM::Mesh_property& p, std::size_t n) {
    return SM::Mesh_property{p.name, p.components, p.type,
                             std::vector<double>(n * std::size_t(p.components))};
  };
  for (const SM::Mesh_property& p : properties.vertex)
    result.vertex.push_back(empty(p, reshaped.number_of_vertices()));
  for (const SM::Mesh_property& p : properties.face)
    result.face.push_back(empty(p, reshaped.number_of_faces()));

  std::size_t i = 0;
  for (const auto v : reshaped.vertices()) {
    const auto [face, weights] = PMP::locate_with_AABB_tree(reshaped.point(v), tree, mesh);
    std::array<std::size_t, 3> corners;
    std::size_t k = 0;
    for (const auto w : CGAL::vertices_around_face(mesh.halfedge(face), mesh)) corners[k++] = std::size_t(w);
    for (std::size_t j = 0; j < properties.vertex.size(); ++j) {
      const std::size_t n = std::size_t(properties.vertex[j].components);
      SM::internal::interpolate(properties.vertex[j], corners, weights, &result.vertex[j].values[n * i]);
    }
    ++i;
  }
  i = 0;
  for (const auto f : reshaped.faces()) {
    const auto h = reshaped.halfedge(f);
    const auto centre = CGAL::centroid(reshaped.point(reshaped.source(h)), reshaped.point(reshaped.target(h)),
                                       reshaped.point(reshaped.target(reshaped.next(h))));
    const auto face = PMP::locate_with_AABB_tree(centre, tree, mesh).first;
    for (std::size_t j = 0; j < properties.face.size(); ++j) {
      const SM::Mesh_property& p = properties.face[j];
      for (std::size_t k = 0; k < std::size_t(p.components); ++k)
        result.face[j].values[std::size_t(p.components) * i + k] = p(std::size_t(face), k);
    }
    ++i;
  }
  return result;
}

} // namespace

void reshape(const Fit_request& request, const Command_line& options, Input& input)
{
  using Reshape = Fit_request::Reshape;
  const bool is_automatic = request.reshape == Reshape::WHERE_NEEDED;
  if (request.reshape == Reshape::NEVER || (is_automatic && options.has("corners"))) return;
  const SM::Face_shapes shapes = SM::face_shapes(input.mesh);
  if (!is_automatic && shapes.has_degenerate)
    throw Usage_error("--reshape always: the mesh has degenerate faces; --repair drops them");
  if (shapes.has_degenerate || (is_automatic && !shapes.is_of_part())) return;
  if (!CGAL::is_triangle_mesh(input.mesh) && !input.read.properties.empty())
    return; // of polygons there is no between
  const Mesh before = input.mesh;
  SM::reshape_flat_parts(input.mesh);
  input.read.properties = properties_at(input.mesh, before, input.read.properties);
  // none of its elements is one of the file
  input.repair.input.vertices.assign(input.mesh.number_of_vertices(), -1);
  input.repair.input.faces.assign(input.mesh.number_of_faces(), -1);
  input.reshape = {{"faces_before", std::size_t(before.number_of_faces())},
                   {"faces", std::size_t(input.mesh.number_of_faces())},
                   {"flat", shapes.flat},
                   {"large", shapes.large},
                   {"slender", shapes.slender}};
}

} // namespace tools
