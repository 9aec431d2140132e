// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_TREE_H
#define CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_TREE_H

#include <CGAL/Simple_manifolds/Triangle.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Binary space partition of the faces of a certified map. Boxes along the axes would fail on the faces that
// maps do have: the slim faces of a hub of many neighbours, or slim faces across the axes, all overlap. So
// the dividing lines may have any direction, and where a line between the faces divides them badly, lines
// along their edges are tried, which divide a fan or a stack of slivers without cutting any.
//
// In the homogeneous coordinates of the pictures that an atlas has of its surface all are one case: a line or a great
// circle is a plane n.x = 0, and a face is on one side of it when its corners are. Each picture has a tree.
//
// Rounding: a face is on the side of a plane that a corner reaches by more than epsilon, and a point nearer
// than `band` is sought on both sides. With |n| = 1 and |x| < 2.2 a computed n.x is wrong by less than
// epsilon / 2.6. A point x = sum l_i v_i of a face has n.x <= (sum l_i) max n.v_i, and sum l_i is at most 1 in
// flat pictures, else 1 / (distance of the face's plane from the origin). So nothing is missed as
// long as it is below 500; longer faces, almost half round the sphere, are also put to the sides that they
// only touch.
template <class Atlas>
class Face_tree {
public:
  using Domain_point = typename Atlas::Domain_point;
  using Points = std::vector<Domain_point>;
  using Faces = std::vector<Triangle>;

  Face_tree(const Atlas& atlas, const Points& points, const Faces& faces)
  {
    Builder(*this, atlas, points, faces).build();
  }

  // Calls test(f) for the faces that may contain x, until it returns true; whether it did.
  template <class Test>
  bool find(const Atlas& atlas, const Domain_point& x, const Test& test) const
  {
    const Eigen::Vector3d p = atlas.homogeneous(x);
    std::array<int, max_depth + 1> other_sides;
    int size = 0, node = root_[atlas.picture(x)];
    for (;;) {
      while (node >= 0) {
        const Node& n = nodes_[node];
        const double s = n.normal[0] * p[0] + n.normal[1] * p[1] + n.normal[2] * p[2];
        if (std::abs(s) <= band) other_sides[size++] = n.child[0];
        node = n.child[s >= -band];
      }
      const int leaf = -1 - node;
      for (int i = leaf_begin_[leaf]; i < leaf_begin_[leaf + 1]; ++i)
        if (test(leaf_faces_[i])) return true;
      if (size == 0) return false;
      node = other_sides[--size];
    }
  }

  std::size_t bytes() const
  {
    return nodes_.capacity() * sizeof(Node) +
           (leaf_begin_.capacity() + leaf_faces_.capacity() + root_.capacity()) * sizeof(int);
  }

private:
  static constexpr double epsilon = 4e-15;
  static constexpr double band = Atlas::has_flat_pictures ? 4 * epsilon : 1024 * epsilon;
  static constexpr int max_depth = 100;

  struct Node {
    std::array<double, 3> normal;
    std::array<int, 2> child; // on the negative and on the positive side; -1 - l is leaf l
  };

  class Builder;

  std::vector<Node> nodes_;
  std::vector<int> leaf_begin_ = {0}, leaf_faces_;
  std::vector<int> root_; // per picture
};

template <class Atlas>
class Face_tree<Atlas>::Builder {
public:
  Builder(Face_tree& tree, const Atlas& atlas, const Points& points, const Faces& faces)
    : tree_(tree), atlas_(atlas), points_(points), faces_(faces)
  {
  }

  void build()
  {
    for (std::vector<Piece>& pieces : all_pieces()) {
      spare_ = 3 * pieces.size() + 1000;
      tree_.root_.push_back(subtree(std::move(pieces), 0));
    }
    tree_.nodes_.shrink_to_fit();
    tree_.leaf_begin_.shrink_to_fit();
    tree_.leaf_faces_.shrink_to_fit();
  }

private:
  static constexpr std::size_t leaf_size = 6;
  static constexpr int sample_size = 48;

  // A copy of a face, of which a picture shows a part.
  struct Piece {
    int face;
    typename Atlas::Picture_copy copy;
  };
  using Corners = std::array<Eigen::Vector3d, 3>;

  Corners corners(const Piece& piece) const
  {
    const Triangle& t = faces_[piece.face];
    return atlas_.homogeneous(points_[t[0]], points_[t[1]], points_[t[2]], piece.copy);
  }

  // Per picture.
  std::vector<std::vector<Piece>> all_pieces() const
  {
    std::vector<std::vector<Piece>> pieces(atlas_.number_of_pictures());
    if (pieces.size() == 1) pieces[0].reserve(faces_.size() + faces_.size() / 8);
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
      const Triangle& t = faces_[f];
      atlas_.for_each_copy(points_[t[0]], points_[t[1]], points_[t[2]],
                           [&](int picture, const typename Atlas::Picture_copy& copy) {
                             pieces[picture].push_back({f, copy});
                           });
    }
    return pieces;
  }

  // Whether the face has to be found on the negative and on the positive side of a plane.
  static std::pair<bool, bool> sides(const Corners& c, const Eigen::Vector3d& normal)
  {
    const double s0 = normal.dot(c[0]), s1 = normal.dot(c[1]), s2 = normal.dot(c[2]);
    const double low = (std::min)(s0, (std::min)(s1, s2)), high = (std::max)(s0, (std::max)(s1, s2));
    const bool is_positive = high > epsilon, is_negative = low < -epsilon;
    if constexpr (!Atlas::has_flat_pictures)
      if (is_positive != is_negative && high >= -epsilon && low <= epsilon && is_long(c)) return {true, true};
    return {is_negative || !is_positive, is_positive};
  }

  // Whether the sum of the l_i may be large: in no face with all edges below acos(-0.45) = 117 degrees.
  static bool is_long(const Corners& c)
  {
    if ((std::min)(c[0].dot(c[1]), (std::min)(c[1].dot(c[2]), c[2].dot(c[0]))) > -0.45) return false;
    const Eigen::Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
    return !(c[0].dot(normal) > 2e-3 * normal.norm());
  }

  int subtree(std::vector<Piece> pieces, int depth)
  {
    Eigen::Vector3d normal;
    const std::size_t n = pieces.size();
    if (n <= leaf_size || depth == max_depth || !choose_plane(pieces, normal)) return leaf(pieces);
    std::vector<Piece> negative, positive;
    negative.reserve(n / 2 + n / 8 + 4);
    positive.reserve(n / 2 + n / 8 + 4);
    for (const Piece& piece : pieces) {
      const auto side = sides(corners(piece), normal);
      if (side.first) negative.push_back(piece);
      if (side.second) positive.push_back(piece);
    }
    const std::size_t copies = negative.size() + positive.size() - n;
    if (copies > spare_ || (std::max)(negative.size(), positive.size()) == n) return leaf(pieces);
    spare_ -= copies;
    std::vector<Piece>().swap(pieces);
    const int node = static_cast<int>(tree_.nodes_.size());
    tree_.nodes_.push_back({{normal[0], normal[1], normal[2]}, {0, 0}});
    const int first = subtree(std::move(negative), depth + 1);
    tree_.nodes_[node].child[0] = first;
    const int second = subtree(std::move(positive), depth + 1);
    tree_.nodes_[node].child[1] = second;
    return node;
  }

  int leaf(const std::vector<Piece>& pieces)
  {
    for (const Piece& piece : pieces) tree_.leaf_faces_.push_back(piece.face);
    tree_.leaf_begin_.push_back(static_cast<int>(tree_.leaf_faces_.size()));
    return 1 - static_cast<int>(tree_.leaf_begin_.size());
  }

  // Judges by a sample. Returns false if no plane divides it.
  bool choose_plane(const std::vector<Piece>& pieces, Eigen::Vector3d& best)
  {
    const std::size_t stride = (pieces.size() + sample_size - 1) / sample_size;
    std::array<Corners, sample_size> sample;
    int n = 0;
    for (std::size_t i = 0; i < pieces.size(); i += stride) sample[n++] = corners(pieces[i]);

    int least = -1; // of the squared sizes of the halves: the smaller, the better divided and the less cut
    const auto consider = [&](const Eigen::Vector3d& direction) {
      const double length = direction.norm();
      if (!(length > 0)) return;
      const Eigen::Vector3d normal = direction / length;
      int negative = 0, positive = 0;
      for (int i = 0; i < n; ++i) {
        const auto side = sides(sample[i], normal);
        negative += side.first;
        positive += side.second;
      }
      const int cost = negative * negative + positive * positive;
      if ((std::max)(negative, positive) < n && (least < 0 || cost < least)) {
        least = cost;
        best = normal;
      }
    };
    across(sample, n, consider);
    if (least < 0 || 100 * least > 81 * n * n) // worse than two halves of 64 %
      for (int i = 0; i < 5; ++i) {
        const Corners& c = sample[(2 * i + 1) * n / 10];
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d &a = c[k], &b = c[(k + 1) % 3];
          consider(a.cross(b - a)); // through both ends, however short the edge is
        }
      }
    return least >= 0;
  }

  // The medians of the centroids in two directions, the longer one first.
  template <class Consider>
  static void across(const std::array<Corners, sample_size>& sample, int n, const Consider& consider)
  {
    std::array<Eigen::Vector3d, sample_size> centroid;
    Eigen::Vector3d mean(0, 0, 0);
    for (int i = 0; i < n; ++i) {
      centroid[i] = sample[i][0] + sample[i][1] + sample[i][2];
      mean += centroid[i];
    }
    Eigen::Vector3d w(0, 0, 1), u(1, 0, 0), v(0, 1, 0);
    if constexpr (!Atlas::has_flat_pictures) {
      w = mean / (3 * n);
      for (int i = 0; i < n; ++i)
        if (!(w.dot(centroid[i]) > 0.3 * centroid[i].norm())) { // faces all round the sphere
          consider(u);
          consider(v);
          consider(Eigen::Vector3d(0, 0, 1));
          return;
        }
      w.normalize();
      u = w.unitOrthogonal();
      v = w.cross(u);
    }
    std::array<double, sample_size> x, y; // central projection along w
    double mean_x = 0, mean_y = 0, spread_x = 0, spread_y = 0;
    for (int i = 0; i < n; ++i) {
      const double scale = w.dot(centroid[i]);
      mean_x += x[i] = u.dot(centroid[i]) / scale;
      mean_y += y[i] = v.dot(centroid[i]) / scale;
    }
    for (int i = 0; i < n; ++i) {
      spread_x += (x[i] - mean_x / n) * (x[i] - mean_x / n);
      spread_y += (y[i] - mean_y / n) * (y[i] - mean_y / n);
    }
    if (spread_x < spread_y) {
      std::swap(x, y);
      std::swap(u, v);
    }
    std::nth_element(x.begin(), x.begin() + n / 2, x.begin() + n);
    consider(u - x[n / 2] * w);
  }

  Face_tree& tree_;
  const Atlas& atlas_;
  const Points& points_;
  const Faces& faces_;
  std::size_t spare_ = 0; // the copies that may still be made
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_CORRESPONDENCE_INTERNAL_LOCATION_FACE_TREE_H
