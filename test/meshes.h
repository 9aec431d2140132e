// Real meshes for the tests: those that come with CGAL.

#ifndef SIMPLE_MANIFOLDS_TEST_MESHES_H
#define SIMPLE_MANIFOLDS_TEST_MESHES_H

#include <fstream>
#include <stdexcept>
#include <string>

/// The path of a mesh of CGAL's data, e.g. `cgal_mesh("hand.off")`.
/// \throw std::runtime_error if the file is missing, so that no test passes without its input
inline std::string cgal_mesh(const std::string& name)
{
  std::string path = std::string(SIMPLE_MANIFOLDS_CGAL_DATA) + "/meshes/" + name;
  if (!std::ifstream(path)) {
    throw std::runtime_error("no mesh " + path + ": scripts/setup fetches CGAL's data");
  }
  return path;
}

#endif // SIMPLE_MANIFOLDS_TEST_MESHES_H
