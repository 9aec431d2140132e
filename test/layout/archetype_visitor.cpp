// A visitor that provides what the concept SimpleManifoldsVisitor promises and nothing more: it derives from
// nothing and cannot be copied. It sees that phases do not nest and that progress does not go back, and it
// can cancel.

#include "../meshes.h"

#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/simple_manifolds.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <functional>
#include <iostream>

namespace SM = CGAL::Simple_manifolds;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

struct Cancelled {};

class Visitor_archetype {
public:
  explicit Visitor_archetype(int last_phase) : last_phase_(last_phase) {}
  Visitor_archetype(const Visitor_archetype&) = delete;
  Visitor_archetype& operator=(const Visitor_archetype&) = delete;

  void start_phase(const char*)
  {
    is_ordered_ &= !in_phase_;
    in_phase_ = true;
    fraction_ = 0;
    if (++phases_ > last_phase_) throw Cancelled();
  }

  void progress(double fraction)
  {
    is_ordered_ &= in_phase_ && fraction_ <= fraction && fraction <= 1;
    fraction_ = fraction;
  }

  void end_phase()
  {
    is_ordered_ &= in_phase_;
    in_phase_ = false;
  }

  int phases() const { return phases_; }
  bool is_ordered() const { return is_ordered_; }
  bool in_phase() const { return in_phase_; }

private:
  int last_phase_;
  int phases_ = 0;
  bool is_ordered_ = true;
  bool in_phase_ = false;
  double fraction_ = 0;
};

int failures = 0;

void check(bool condition, const char* what)
{
  if (condition) return;
  std::cerr << "failed: " << what << '\n';
  ++failures;
}

int main()
{
  Mesh mesh;
  SM::read_mesh(cgal_mesh("hand.off"), mesh);

  Visitor_archetype patient(1000);
  const auto map = SM::map_to_sphere(mesh, CGAL::parameters::visitor(std::ref(patient)));
  check(patient.phases() > 0 && patient.is_ordered() && !patient.in_phase(), "the phases of map_to_sphere");

  Visitor_archetype also_patient(1000);
  SM::fit_surface(map, SM::parameters::rms_error(0.05).visitor(std::ref(also_patient)));
  check(also_patient.phases() > 0 && also_patient.is_ordered() && !also_patient.in_phase(),
        "the phases of fit_surface");

  Visitor_archetype impatient(patient.phases() - 1);
  bool is_cancelled = false;
  try {
    SM::map_to_sphere(mesh, CGAL::parameters::visitor(std::ref(impatient)));
  } catch (const Cancelled&) {
    is_cancelled = true;
  }
  check(is_cancelled, "an exception of the visitor comes out of map_to_sphere");

  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
