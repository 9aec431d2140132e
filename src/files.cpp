// Of the compiled library: files, repair of what is in them, and what reports show.

#include <CGAL/Simple_manifolds/IO/internal/read_file_mesh_impl.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface_impl.h>
#include <CGAL/Simple_manifolds/cad/Cad_tessellation_impl.h>
#include <CGAL/Simple_manifolds/repair/repair_soup_impl.h>
#include <CGAL/Simple_manifolds/repair/reshape_flat_parts_impl.h>
