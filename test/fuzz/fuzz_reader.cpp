// Whatever the bytes, a reader returns what it read or throws an error of the package.
//
// scripts/fuzz makes a libFuzzer program of this file and replay.cpp a test. The environment's FUZZ_FORMAT is
// off, obj, stl, ply, vtk, vtp, gii, freesurfer, 3mf, dae (meshes), map (a PLY file with a map) or surface (JSON and CBOR).

#include <CGAL/Simple_manifolds/IO/internal/Ply_file.h>
#include <CGAL/Simple_manifolds/IO/internal/read_3mf.h>
#include <CGAL/Simple_manifolds/IO/internal/read_collada.h>
#include <CGAL/Simple_manifolds/IO/internal/read_freesurfer.h>
#include <CGAL/Simple_manifolds/IO/internal/read_gifti.h>
#include <CGAL/Simple_manifolds/IO/internal/read_obj.h>
#include <CGAL/Simple_manifolds/IO/internal/read_off.h>
#include <CGAL/Simple_manifolds/IO/internal/read_stl.h>
#include <CGAL/Simple_manifolds/IO/internal/read_vtk.h>
#include <CGAL/Simple_manifolds/IO/internal/read_vtk_xml.h>
#include <CGAL/Simple_manifolds/IO/map_io.h>
#include <CGAL/Simple_manifolds/IO/read_mesh.h>
#include <CGAL/Simple_manifolds/IO/surface_io.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace SM = CGAL::Simple_manifolds;

namespace {

const std::string file = "input";

template <class Contents>
void check_mesh(const Contents& mesh)
{
  SM::internal::checked_topology(file, mesh);
}

void off(const std::string& bytes) { check_mesh(SM::internal::read_off(file, bytes)); }
void obj(const std::string& bytes) { check_mesh(SM::internal::read_obj(file, bytes)); }
void stl(const std::string& bytes) { check_mesh(SM::internal::read_stl(file, bytes)); }
void ply(const std::string& bytes) { check_mesh(SM::internal::Ply_file(file, bytes).mesh()); }

void vtk(const std::string& bytes) { check_mesh(SM::internal::read_vtk(file, bytes)); }
void vtp(const std::string& bytes) { check_mesh(SM::internal::read_vtk_xml(file, bytes)); }
void gii(const std::string& bytes) { check_mesh(SM::internal::read_gifti(file, bytes)); }
void freesurfer(const std::string& bytes) { check_mesh(SM::internal::read_freesurfer(file, bytes)); }

void dae(const std::string& bytes) { check_mesh(SM::internal::read_collada(file, bytes)); }

// An archive, or the model in one: in an archive the checksum would refuse nearly all changes.
void three_mf(const std::string& bytes)
{
  if (bytes.compare(0, 2, "PK") == 0) return check_mesh(SM::internal::read_3mf(file, bytes));
  const auto part = [&](std::string_view path) {
    return path == "_rels/.rels" ? std::nullopt : std::optional<std::string>(bytes);
  };
  check_mesh(SM::internal::Three_mf_reader(file, part, bytes.size()).read());
}

// What a map file holds may be a bijection: then both directions have to work.
template <class Atlas>
void use_map(const SM::Manifold_map<Atlas>& map)
{
  const auto location = map.to_mesh(map.domain_point(0));
  if (!(map.to_domain(location) - map.domain_point(0)).allFinite()) std::abort();
}

void read_map(const std::string& bytes)
{
  SM::internal::Ply_file p(file, bytes);
  const std::string atlas = SM::internal::value_of_comment(p, "atlas");
  if (atlas == "plane")
    use_map(SM::internal::map_of_ply<SM::Plane_atlas>(p, file));
  else if (atlas == "sphere")
    use_map(SM::internal::map_of_ply<SM::Sphere_atlas>(p, file));
  else if (atlas == "torus")
    use_map(SM::internal::map_of_ply<SM::Torus_atlas>(p, file));
}

template <class Surface>
void use_surface(const SM::internal::Json_field& root)
{
  const Surface surface = SM::internal::surface_of_json<Surface>(root);
  surface.jet(typename Surface::Domain_point(Surface::Domain_point::Unit(0)));
}

template <class Embedding>
void surface_with(const SM::internal::Json_field& root)
{
  const std::string atlas = SM::internal::header_of_json(root).atlas;
  if (atlas == "plane")
    use_surface<SM::Manifold_surface<SM::Plane_atlas, Embedding>>(root);
  else if (atlas == "sphere")
    use_surface<SM::Manifold_surface<SM::Sphere_atlas, Embedding>>(root);
  else
    use_surface<SM::Manifold_surface<SM::Torus_atlas, Embedding>>(root);
}

void surface(const std::string& bytes)
{
  const nlohmann::json j = SM::internal::parse_document(file, bytes);
  const SM::internal::Json_field root(file, j);
  try {
    surface_with<SM::Hierarchical_embedding>(root);
  } catch (const SM::Error&) {
    surface_with<SM::Patch_stack_embedding>(root);
  }
}

void (*reader())(const std::string&)
{
  const char* format = std::getenv("FUZZ_FORMAT");
  const std::map<std::string, void (*)(const std::string&)> readers = {
    {"off", off},      {"obj", obj}, {"stl", stl},      {"ply", ply},
    {"vtk", vtk},      {"vtp", vtp}, {"gii", gii},      {"freesurfer", freesurfer},
    {"3mf", three_mf}, {"dae", dae}, {"map", read_map}, {"surface", surface}};
  const auto found = readers.find(format ? format : "");
  if (found == readers.end()) {
    std::cerr
      << "FUZZ_FORMAT has to be off, obj, stl, ply, vtk, vtp, gii, freesurfer, 3mf, dae, map or surface\n";
    std::exit(2);
  }
  return found->second;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static void (*const read)(const std::string&) = reader();
  try {
    read(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const SM::Error&) {
  }
  return 0;
}
