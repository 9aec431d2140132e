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
#include <CGAL/Simple_manifolds/atlas/Trivial_deck.h>
#include <CGAL/Simple_manifolds/correspondence/topology.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
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
  std::string sentence() const;
};

namespace internal {

inline constexpr std::size_t max_named_offenders = 16;

inline void name_offender(std::vector<int>& names, std::size_t element)
{
  if (names.size() < max_named_offenders) names.push_back(static_cast<int>(element));
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
    if (!points[v].allFinite() || !atlas.is_valid(points[v])) {
      ++certificate.out_of_range;
      name_offender(certificate.offending_vertices, v);
    }
  }
  constexpr bool has_copies = !std::is_same_v<typename Atlas::Deck, Trivial_deck>;
  if (!finite || (has_copies && certificate.out_of_range > 0)) return; // no sign has a meaning

  double total = 0, smallest = (std::numeric_limits<double>::max)();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& a = points[faces[f][0]];
    const auto& b = points[faces[f][1]];
    const auto& c = points[faces[f][2]];
    const bool liftable = atlas.is_triangle(a, b, c);
    const int sign = atlas.orientation(a, b, c);
    certificate.unliftable += !liftable;
    certificate.flipped += sign < 0;
    certificate.degenerate += sign == 0;
    if (sign <= 0 || !liftable) name_offender(certificate.offending_faces, f);
    const double area = sign == 0 ? 0. : atlas.signed_area(a, b, c);
    total += area;
    smallest = (std::min)(smallest, area);
  }
  certificate.degree = total / atlas.area();
  certificate.smallest_domain_area = smallest;
  // The degree of a map between closed surfaces is an integer, and that to the square follows from its
  // border: the tolerance is no threshold, it only absorbs rounding.
  certificate.degree_is_one = std::abs(certificate.degree - 1) <= Atlas::degree_tolerance;
  if (const std::optional<bool> exact = atlas.covers_once(points, faces)) {
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
  certificate.topology_ok = topology.is_connected() && topology.genus == atlas.genus() &&
                            topology.border_loops == (Atlas::is_closed ? 0 : 1);
  certificate.topology_message = topology.sentence();
  certify_faces(atlas, points, faces, certificate);
  certificate.border_ok = true;
  if constexpr (!Atlas::is_closed) {
    const Triangle_soup soup(static_cast<int>(points.size()), faces);
    const auto loops = border_loops(soup, opposite);
    if (loops.size() == 1) certificate.border_message = atlas.border_fault(points, loops[0]);
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

#ifndef CGAL_SIMPLE_MANIFOLDS_COMPILED
#include <CGAL/Simple_manifolds/correspondence/certify_impl.h>
#endif

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_CERTIFY_H
