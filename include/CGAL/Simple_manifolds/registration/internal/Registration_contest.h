// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_CONTEST_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_CONTEST_H

#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/registration/internal/Coarse_to_fine_registration.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_improvement.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_request.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// One of two surfaces laid out coarse to fine against the other one.
template <class Geometry>
struct One_way {
  using Landmarks = std::vector<Indexed_landmark<typename Geometry::Point>>;

  One_way(const Registered_surface<Geometry>& moved, const Registered_surface<Geometry>& fixed,
          const Landmarks& landmarks, const Registration_options& options)
    : lift(fixed.lift()), layout(moved, lift, landmarks, options)
  {
  }

  Lift<Geometry> lift;
  Coarse_to_fine_registration<Geometry> layout;
  Registration_course course;
};

// Lays out the source against the target, and, where that leaves much distortion, the other way and from other starts:
// moved faces of one surface can be too coarse for a limb of the other one, and coarse levels cannot tell that. A little
// polishing can: the layout that it leaves with the least energy is the result.
template <class Geometry>
class Registration_contest {
public:
  using Points = std::vector<typename Geometry::Point>;

  struct Layout {
    bool is_backwards; // the target was moved
    double energy;     // after a little polishing
    Points source, target;
    std::size_t exact_at;
    std::vector<double> rotations;
  };

  Registration_contest(const Registered_surface<Geometry>& source, const Registered_surface<Geometry>& target,
                       const Registration_request& request, const Registration_options& options)
    : source_(source), target_(target), request_(request), options_(options), polished_source_(source),
      polished_target_(target), improvement_(polished_source_, polished_target_, request, options),
      aligned_(source.domain_points)
  {
  }

  Registration_contest(const Registration_contest&) = delete; // it refers to itself
  Registration_contest& operator=(const Registration_contest&) = delete;

  void run()
  {
    run(false);
    if (!request_.has_fixed_target && !is_decided()) run(true);
  }

  // Nothing: landmarks were not met, or doubles do not suffice.
  const std::optional<Layout>& best() const { return best_; }
  // The landmarks that were not met from the best start.
  const std::vector<int>& unreached() const { return unreached_; }
  // The domain points that the source came with, aligned with the target as a whole.
  const Points& aligned_points() const { return aligned_; }

  // The best layout, improved as far as the effort goes; it may be called when there is one.
  void improve()
  {
    restart(best_->is_backwards, best_->source, best_->target);
    improvement_.polish();
  }
  // The same of the given maps, with these domain points of the source.
  void improve(const Points& given)
  {
    restart(false, given, target_.domain_points);
    improvement_.polish();
  }
  const Registered_surface<Geometry>& improved_source() const { return polished_source_; }
  const Registered_surface<Geometry>& improved_target() const { return polished_target_; }
  const std::vector<double>& energies() const { return improvement_.energies(); }

private:
  // Less energy than that is not looked for. Many landmarks tell which layout is right, while a little polishing of so
  // many that are held does not tell it of wrong ones.
  bool is_decided() const
  {
    constexpr double enough = 1.75;
    constexpr std::size_t many = 6;
    return best_ && (best_->energy <= enough || request_.landmarks.size() > many);
  }

  void restart(bool is_backwards, const Points& source, const Points& target)
  {
    polished_source_.domain_points = source;
    polished_target_.domain_points = target;
    improvement_.start(is_backwards);
  }

  void run(bool is_backwards)
  {
    using Domain = Registration_domain<Geometry>;
    const Registered_surface<Geometry>&moved = is_backwards ? target_ : source_,
          &fixed = is_backwards ? source_ : target_;
    typename One_way<Geometry>::Landmarks landmarks;
    for (const auto& [first, second] : request_.landmarks)
      landmarks.push_back({is_backwards ? second : first,
                           Domain::on_grid(fixed.domain_points[is_backwards ? first : second]), 1});
    One_way<Geometry> way(moved, fixed, landmarks, options_);
    // How many layouts there are going to be is not known: each takes half of what is left.
    double before = done_;
    const auto progress = [&](double fraction) {
      done_ = (std::max)(done_, before + (1 - before) / 2 * (std::min)(fraction, 1.));
      request_.visitor.progress(done_);
    };
    const auto of_layout = [&](double fraction) { progress(0.6 * fraction); };
    const int starts = request_.effort == Effort::FAST ? 1 : request_.effort == Effort::QUALITY ? 4 : 2;
    if (!way.layout.begin(starts, way.course, of_layout)) return;
    if (!is_backwards) aligned_ = way.layout.aligned_points();
    for (int k = 0; k < way.layout.number_of_starts() && !is_decided(); ++k) {
      before = done_;
      auto points = way.layout.finish(k, way.course, of_layout);
      if (!points) continue;
      if (!way.course.unreached.empty()) {
        if (!is_backwards && unreached_.empty()) unreached_ = way.course.unreached;
        continue;
      }
      restart(is_backwards, is_backwards ? source_.domain_points : *points,
              is_backwards ? *points : target_.domain_points);
      improvement_.try_out([&](double fraction) { progress(0.6 + 0.4 * fraction); });
      const double energy = improvement_.energies().back();
      if (best_ && !(energy < best_->energy)) continue;
      best_ = Layout{is_backwards,
                     energy,
                     polished_source_.domain_points,
                     polished_target_.domain_points,
                     way.course.exact_at,
                     way.course.rotations};
    }
  }

  const Registered_surface<Geometry>&source_, &target_;
  const Registration_request& request_;
  const Registration_options& options_;
  Registered_surface<Geometry> polished_source_, polished_target_;
  Registration_improvement<Geometry> improvement_;
  Points aligned_;
  std::optional<Layout> best_;
  std::vector<int> unreached_;
  double done_ = 0; // of the search
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_CONTEST_H
