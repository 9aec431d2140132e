// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CERTIFY_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CERTIFY_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/correspondence/internal/geometry/domain_geometry.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// The proof that a map is one to one, or what is wrong with it. All signs are those of the stored
/// doubles, decided exactly.
struct Certificate {
  std::size_t faces = 0;               ///< of the map
  std::size_t flipped = 0;             ///< faces that are negative in the domain
  std::size_t degenerate = 0;          ///< faces without area in the domain
  std::size_t unliftable = 0;          ///< torus: faces with an edge of size 1/2 or that wind round a handle
  std::vector<int> offending_faces;    ///< the first 16 of all these
  std::size_t out_of_range = 0;        ///< vertices whose domain point is none
  std::vector<int> offending_vertices; ///< the first 16 of them
  double degree = 0;                   ///< signed area of all faces over the area of the domain
  double smallest_domain_area = 0;     ///< signed, of one face; on the sphere in steradians
  bool degree_is_one = false;          ///< the faces cover the domain once
  bool area_is_exact = false;          ///< torus, square: the areas were summed exactly, not in doubles
  bool topology_ok = false;            ///< a surface of the domain's genus and border, connected
  std::string topology_message;        ///< what the mesh is, or why it is no surface
  bool border_ok = false;              ///< square: the border runs once round; true for the others
  std::string border_message;          ///< empty when it is right

  /// Whether the map is one to one, onto, and orientation preserving.
  bool is_valid() const
  {
    return faces > 0 && flipped == 0 && degenerate == 0 && unliftable == 0 && out_of_range == 0 &&
           degree_is_one && topology_ok && border_ok;
  }

  /// The verdict with the numbers, in one sentence.
  std::string sentence() const
  {
    if (is_valid())
      return "the map is one to one: all " + std::to_string(faces) + " faces are positive, degree 1" +
             (area_is_exact ? ", total area exactly 1" : "");
    std::string s = "the map is not one to one";
    const char* separator = ": ";
    const auto add = [&](bool wrong, const std::string& what) {
      if (wrong) {
        s += separator + what;
        separator = "; ";
      }
    };
    add(!topology_ok, topology_message);
    std::string names;
    for (int v : offending_vertices) names += " " + std::to_string(v);
    add(out_of_range > 0,
        std::to_string(out_of_range) + " vertices have no point of the domain, first:" + names);
    names.clear();
    for (int f : offending_faces) names += " " + std::to_string(f);
    const std::string lifts = unliftable > 0 ? ", " + std::to_string(unliftable) + " not liftable" : "";
    add(flipped + degenerate + unliftable > 0, std::to_string(flipped) + " flipped, " +
                                                 std::to_string(degenerate) + " degenerate" + lifts + " of " +
                                                 std::to_string(faces) + " faces, first:" + names);
    add(flipped == faces && faces > 0, "all faces are negative, the map has the opposite orientation");
    add(!border_ok && !border_message.empty(), border_message);
    add(!degree_is_one && topology_ok && out_of_range == 0, "degree " + std::to_string(degree));
    return s;
  }
};

namespace internal {

inline constexpr std::size_t max_named_offenders = 16;

inline void name_offender(std::vector<int>& names, std::size_t element)
{
  if (names.size() < max_named_offenders) names.push_back(static_cast<int>(element));
}

// The side of the square (0 bottom, 1 right, 2 top, 3 left) of a border point, and how far along it,
// counterclockwise; a corner belongs to the side that it starts. Off the border the side is -1.
inline std::pair<int, double> place_on_square(const Eigen::Vector2d& p)
{
  if (p.y() == 0 && p.x() < 1) return {0, p.x()};
  if (p.x() == 1 && p.y() < 1) return {1, p.y()};
  if (p.y() == 1 && p.x() > 0) return {2, -p.x()};
  return {p.x() == 0 ? 3 : -1, -p.y()};
}

// What is wrong with the border of a map to the square, or nothing: it has to hit the four corners
// and to run once round, strictly forward. `loop` are the border vertices in order.
inline std::string border_fault(const std::vector<Eigen::Vector2d>& points, std::vector<int> loop)
{
  for (int v : loop)
    if (place_on_square(points[v]).first == -1)
      return "border vertex " + std::to_string(v) + " lies off the border of the square";
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1), Eigen::Vector2d(0, 1)}) {
    const auto hits = std::count_if(loop.begin(), loop.end(), [&](int v) { return points[v] == corner; });
    if (hits != 1)
      return std::to_string(hits) + " border vertices lie at the corner (" + std::to_string(int(corner.x())) +
             "," + std::to_string(int(corner.y())) + ") of the square";
  }
  const auto origin = std::find_if(loop.begin(), loop.end(), [&](int v) { return points[v].isZero(0); });
  std::rotate(loop.begin(), origin, loop.end());
  for (std::size_t i = 1; i < loop.size(); ++i)
    if (!(place_on_square(points[loop[i - 1]]) < place_on_square(points[loop[i]])))
      return "the border goes back or stands still at vertex " + std::to_string(loop[i]);
  return std::string();
}

// Whether the signed areas of the faces sum exactly to 1; nothing if a coordinate is not a multiple of 2^-52 in [0,1].
// On the torus the faces are those of the nearest lifts.
inline std::optional<bool> total_area_is_one(const std::vector<Eigen::Vector2d>& points,
                                             const std::vector<Triangle>& faces, bool is_torus)
{
  const double unit = 4503599627370496.; // 2^52
  const auto on_grid = [&](double x) { return 0 <= x && x <= 1 && std::floor(x * unit) == x * unit; };
  boost::multiprecision::int128_t sum = 0; // of twice the areas, in units of 2^-104
  for (const Triangle& t : faces) {
    for (int v : t)
      if (!on_grid(points[v][0]) || !on_grid(points[v][1])) return std::nullopt;
    std::array<std::array<std::int64_t, 2>, 2> edge; // from corner 0, exact
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d &p = points[t[0]], &q = points[t[k + 1]];
      const Eigen::Vector2i lift = is_torus ? Torus_atlas::lift_offset(p, q) : Eigen::Vector2i(0, 0);
      for (int i = 0; i < 2; ++i)
        edge[k][i] = static_cast<std::int64_t>(q[i] * unit) - static_cast<std::int64_t>(p[i] * unit) +
                     lift[i] * static_cast<std::int64_t>(unit);
    }
    sum += boost::multiprecision::int128_t(edge[0][0]) * edge[1][1];
    sum -= boost::multiprecision::int128_t(edge[0][1]) * edge[1][0];
  }
  return sum == boost::multiprecision::int128_t(1) << 105;
}

// The ranges of the vertices; signs, lifts and degree of the faces.
template <class Atlas>
void certify_faces(const Atlas& atlas, const std::vector<typename Atlas::Domain_point>& points,
                   const std::vector<Triangle>& faces, Certificate& certificate)
{
  std::vector<char> used(points.size(), false);
  for (const Triangle& t : faces)
    for (int v : t) used[v] = true;
  bool finite = true;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!used[v]) continue;
    finite = finite && points[v].allFinite();
    if (!points[v].allFinite() || !is_in_range(atlas, points[v])) {
      ++certificate.out_of_range;
      name_offender(certificate.offending_vertices, v);
    }
  }
  if (!finite || (std::is_same_v<Atlas, Torus_atlas> && certificate.out_of_range > 0))
    return; // no sign has a meaning

  double total = 0, smallest = (std::numeric_limits<double>::max)();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& a = points[faces[f][0]];
    const auto& b = points[faces[f][1]];
    const auto& c = points[faces[f][2]];
    bool liftable = true;
    if constexpr (std::is_same_v<Atlas, Torus_atlas>) liftable = is_liftable(a, b, c);
    const int sign = atlas.orientation(a, b, c);
    certificate.unliftable += !liftable;
    certificate.flipped += sign < 0;
    certificate.degenerate += sign == 0;
    if (sign <= 0 || !liftable) name_offender(certificate.offending_faces, f);
    const double area = sign == 0 ? 0. : signed_area(atlas, a, b, c);
    total += area;
    smallest = (std::min)(smallest, area);
  }
  certificate.degree = total / Atlas::area;
  certificate.smallest_domain_area = smallest;
  // The degree of a map between closed surfaces is an integer, and that to the square follows from its
  // border: the tolerance is no threshold, it only absorbs rounding. On torus and square the areas of the
  // points that the mapper makes, on the grid of 2^-52, are also summed exactly.
  const double tolerance = std::is_same_v<Atlas, Sphere_atlas> ? 1e-6 : 1e-9;
  certificate.degree_is_one = std::abs(certificate.degree - 1) <= tolerance;
  if constexpr (!std::is_same_v<Atlas, Sphere_atlas>)
    if (const std::optional<bool> exact = total_area_is_one(points, faces, Atlas::is_closed)) {
      certificate.area_is_exact = true;
      certificate.degree_is_one = *exact;
    }
}

// The mesh is a surface of the domain's kind, so only the domain points remain to be examined.
template <class Atlas>
Certificate certify_surface(const Atlas& atlas, const std::vector<typename Atlas::Domain_point>& points,
                            const std::vector<Triangle>& faces, const std::vector<int>& opposite,
                            const Mesh_topology& topology)
{
  Certificate certificate;
  certificate.faces = faces.size();
  certificate.topology_ok = topology.is_connected() && topology.genus == Atlas::genus &&
                            topology.border_loops == (Atlas::is_closed ? 0 : 1);
  certificate.topology_message = topology.sentence();
  certify_faces(atlas, points, faces, certificate);
  certificate.border_ok = true;
  if constexpr (!Atlas::is_closed) {
    const Triangle_soup soup(static_cast<int>(points.size()), faces);
    const auto loops = border_loops(soup, opposite);
    if (loops.size() == 1) certificate.border_message = border_fault(points, loops[0]);
    certificate.border_ok = loops.size() == 1 && certificate.border_message.empty();
  }
  return certificate;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsCorrespondence
///
/// Examines any map of a triangle mesh onto a canonical surface, made by this package or elsewhere.
///
/// The map is one to one when the mesh is a connected surface of the right genus and border, every face
/// is positive in the domain, and the degree is one (on the square: the border runs once round it).
/// On the torus each coordinate difference of an edge is reduced to the nearest lift; the differences
/// have to close round each face and none may be 1/2 in size. Linear time; vertices of no face are ignored.
///
/// \param domain_points  one per vertex: unit vectors (to 1e-9) on the sphere, in [0,1)^2 on the torus,
///   in [0,1]^2 on the square
/// \param faces  positions in `domain_points`
/// \return the certificate; never throws because of bad data
template <class Atlas>
Certificate certify(const Atlas& atlas, const std::vector<typename Atlas::Domain_point>& domain_points,
                    const std::vector<Triangle>& faces)
{
  Certificate certificate;
  certificate.faces = faces.size();
  std::vector<int> opposite;
  try {
    const internal::Triangle_soup soup(static_cast<int>(domain_points.size()), faces);
    const Mesh_topology topology = internal::topology_of_soup(soup, opposite);
    return internal::certify_surface(atlas, domain_points, faces, opposite, topology);
  } catch (const Topology_error& error) {
    certificate.topology_message = error.what();
    certificate.border_ok = Atlas::is_closed;
    if (error.code() == Error_code::degenerate_face)
      internal::name_offender(certificate.offending_faces, error.element().first);
    else if (!faces.empty())
      internal::certify_faces(atlas, domain_points, faces, certificate);
    return certificate;
  }
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CERTIFY_H
