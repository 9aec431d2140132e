// Of the compiled library: registration.

#include <CGAL/Simple_manifolds/atlas/canonical_surfaces.h>
#include <CGAL/Simple_manifolds/registration/register_maps.h>

#undef CGAL_SIMPLE_MANIFOLDS_INSTANTIATE // from here on, templates are made here
#define CGAL_SIMPLE_MANIFOLDS_INSTANTIATE template

#include <CGAL/Simple_manifolds/registration/register_maps_impl.h>
