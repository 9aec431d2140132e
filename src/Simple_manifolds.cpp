// The compiled library: everything that headers declare to be in it.

#define CGAL_SIMPLE_MANIFOLDS_INSTANTIATE template

#include <CGAL/simple_manifolds.h>
