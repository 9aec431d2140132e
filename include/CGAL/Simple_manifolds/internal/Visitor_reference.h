// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_VISITOR_REFERENCE_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_VISITOR_REFERENCE_H

#include <CGAL/Simple_manifolds/Visitor.h>

#include <CGAL/Simple_manifolds/Error.h>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// A visitor of any type behind one type, so that engines are compiled once and not for each type of visitor. It is
// called rarely. The visitor must outlive it.
class Visitor_reference {
public:
  // No visitor.
  Visitor_reference()
    : visitor_(nullptr), start_phase_([](void*, const char*) {}), progress_([](void*, double) {}),
      end_phase_([](void*) {})
  {
  }

  template <class Visitor>
  explicit Visitor_reference(Visitor& visitor)
    : visitor_(const_cast<void*>(static_cast<const void*>(&visitor))), // which may be a const one
      start_phase_([](void* v, const char* name) { static_cast<Visitor*>(v)->start_phase(name); }),
      progress_([](void* v, double fraction) { static_cast<Visitor*>(v)->progress(fraction); }),
      end_phase_([](void* v) { static_cast<Visitor*>(v)->end_phase(); })
  {
  }

  void start_phase(const char* name) const { start_phase_(visitor_, name); }
  void progress(double fraction) const { progress_(visitor_, fraction); }
  void end_phase() const { end_phase_(visitor_); }

private:
  void* visitor_;
  void (*start_phase_)(void*, const char*);
  void (*progress_)(void*, double);
  void (*end_phase_)(void*);
};

// Runs a phase, which ends where double precision does not suffice, too: that is not the end of all.
template <class F>
void in_phase(const Visitor_reference& visitor, const char* name, const F& f)
{
  visitor.start_phase(name);
  try {
    f();
  } catch (const Numeric_error&) {
    visitor.end_phase();
    throw;
  }
  visitor.end_phase();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_VISITOR_REFERENCE_H
