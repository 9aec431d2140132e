// The module simple_manifolds._core: what the package is built on.

#include "calls.h"

#include <CGAL/Simple_manifolds/Error.h>

#include <exception>
#include <string>

namespace simple_manifolds_python {

namespace {

const char* name_of(SM::Error_code code)
{
  switch (code) {
#define SIMPLE_MANIFOLDS_PYTHON_CODE(name)                                                                   \
  case SM::Error_code::name:                                                                                 \
    return #name;
    SIMPLE_MANIFOLDS_PYTHON_CODE(empty_mesh)
    SIMPLE_MANIFOLDS_PYTHON_CODE(too_many_faces)
    SIMPLE_MANIFOLDS_PYTHON_CODE(not_closed)
    SIMPLE_MANIFOLDS_PYTHON_CODE(no_border)
    SIMPLE_MANIFOLDS_PYTHON_CODE(several_components)
    SIMPLE_MANIFOLDS_PYTHON_CODE(several_border_loops)
    SIMPLE_MANIFOLDS_PYTHON_CODE(wrong_genus)
    SIMPLE_MANIFOLDS_PYTHON_CODE(non_manifold_vertex)
    SIMPLE_MANIFOLDS_PYTHON_CODE(non_manifold_edge)
    SIMPLE_MANIFOLDS_PYTHON_CODE(inconsistent_orientation)
    SIMPLE_MANIFOLDS_PYTHON_CODE(doubled_edge)
    SIMPLE_MANIFOLDS_PYTHON_CODE(degenerate_face)
    SIMPLE_MANIFOLDS_PYTHON_CODE(unsupported_face)
    SIMPLE_MANIFOLDS_PYTHON_CODE(non_finite_coordinate)
    SIMPLE_MANIFOLDS_PYTHON_CODE(zero_extent)
    SIMPLE_MANIFOLDS_PYTHON_CODE(extent_out_of_range)
    SIMPLE_MANIFOLDS_PYTHON_CODE(element_not_mapped)
    SIMPLE_MANIFOLDS_PYTHON_CODE(map_not_bijective)
    SIMPLE_MANIFOLDS_PYTHON_CODE(numeric_failure)
    SIMPLE_MANIFOLDS_PYTHON_CODE(landmarks_not_met)
    SIMPLE_MANIFOLDS_PYTHON_CODE(partition_failed)
    SIMPLE_MANIFOLDS_PYTHON_CODE(cannot_open)
    SIMPLE_MANIFOLDS_PYTHON_CODE(unsupported_format)
    SIMPLE_MANIFOLDS_PYTHON_CODE(syntax_error)
    SIMPLE_MANIFOLDS_PYTHON_CODE(cannot_write)
#undef SIMPLE_MANIFOLDS_PYTHON_CODE
  }
  return "";
}

// The classes of exceptions; the interpreter never lets go of them.
PyObject *error_class, *topology_class, *geometry_class, *numeric_class, *file_class;

PyObject* add_class(py::module_& m, const char* name, PyObject* base, const char* doc)
{
  PyObject* result =
    PyErr_NewExceptionWithDoc((std::string("simple_manifolds.") + name).c_str(), doc, base, nullptr);
  if (result == nullptr) throw py::error_already_set();
  m.add_object(name, py::reinterpret_borrow<py::object>(result));
  return result;
}

py::object error_of(PyObject* type, const SM::Error& e)
{
  static const char* const kinds[] = {"", "vertex", "edge", "face"};
  py::object error = py::reinterpret_borrow<py::object>(type)(py::str(e.what()));
  error.attr("code") = name_of(e.code());
  const SM::Mesh_element& element = e.element();
  if (element.kind == SM::Mesh_element::NONE)
    error.attr("element") = py::none();
  else if (element.kind == SM::Mesh_element::EDGE)
    error.attr("element") = py::make_tuple(kinds[element.kind], element.first, element.second);
  else
    error.attr("element") = py::make_tuple(kinds[element.kind], element.first);
  return error;
}

void raise(PyObject* type, const SM::Error& e) { PyErr_SetObject(type, error_of(type, e).ptr()); }

} // namespace

// The exception of an error whose class got lost.
py::object exception_of(const SM::Error& e)
{
  if (e.code() < SM::Error_code::non_finite_coordinate) return error_of(topology_class, e);
  if (e.code() < SM::Error_code::element_not_mapped) return error_of(geometry_class, e);
  return error_of(numeric_class, e);
}

void add_errors(py::module_& m)
{
  error_class = add_class(
    m, "Error", PyExc_Exception,
    "Bad data, which no repair can mend. `code` is a word to branch on, such as 'not_closed'; `element` is "
    "None or the offending one: ('vertex', v), ('edge', v, w) or ('face', f).");
  topology_class =
    add_class(m, "TopologyError", error_class,
              "The mesh is not a surface of the kind that is needed; the message says what it is.");
  geometry_class =
    add_class(m, "GeometryError", error_class, "Coordinates that are not finite, or a mesh without extent.");
  numeric_class = add_class(m, "NumericError", error_class,
                            "A computation failed, or a map that was handed in is not one to one.");
  file_class =
    add_class(m, "FileError", error_class,
              "A file cannot be read or written: also `file`, and `line`, which is None where lines have no "
              "meaning.");
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const SM::IO_error& e) {
      py::object error = error_of(file_class, e);
      error.attr("file") = e.file();
      error.attr("line") = e.line() == 0 ? py::object(py::none()) : py::object(py::int_(e.line()));
      PyErr_SetObject(file_class, error.ptr());
    } catch (const SM::Topology_error& e) {
      raise(topology_class, e);
    } catch (const SM::Geometry_error& e) {
      raise(geometry_class, e);
    } catch (const SM::Numeric_error& e) {
      raise(numeric_class, e);
    } catch (const SM::Error& e) {
      raise(error_class, e);
    }
  });
}

} // namespace simple_manifolds_python

PYBIND11_MODULE(_core, m)
{
  using namespace simple_manifolds_python;
  m.doc() = "The compiled part of simple_manifolds.";
  add_errors(m);
  add_meshes(m);
  add_maps(m);
  add_map_functions(m);
  add_surfaces(m);
  add_evaluation(m);
  add_closest_points(m);
  add_tessellations(m);
  add_cad(m);
  add_registration(m);
}
