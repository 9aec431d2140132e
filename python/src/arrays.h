// Arrays of numpy and of the package: the same memory wherever the layout allows it.

#ifndef SIMPLE_MANIFOLDS_PYTHON_ARRAYS_H
#define SIMPLE_MANIFOLDS_PYTHON_ARRAYS_H

#include <CGAL/Simple_manifolds/Triangle.h>
#include <CGAL/Simple_manifolds/atlas/Chart_point.h>

#include <Eigen/Core>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;
namespace SM = CGAL::Simple_manifolds;

namespace simple_manifolds_python {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Ints = py::array_t<int, py::array::c_style | py::array::forcecast>;

// A row of an array: the scalars that an object consists of.
template <class T>
struct Row {
  using Scalar = T;
  static constexpr int columns = 0; // a number of its own
};
template <int n>
struct Row<Eigen::Matrix<double, n, 1>> {
  using Scalar = double;
  static constexpr int columns = n;
};
template <>
struct Row<SM::Triangle> {
  using Scalar = int;
  static constexpr int columns = 3;
};

[[noreturn]] inline void wrong(const std::string& message) { throw py::value_error(message); }
inline void require(bool condition, const char* message)
{
  if (!condition) wrong(message);
}

// An array of Python that is the memory of a vector of C++; `owner` keeps the vector alive. Read-only.
template <class T>
py::array view(const std::vector<T>& values, const py::handle& owner)
{
  using Scalar = typename Row<T>::Scalar;
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(values.size())};
  if (Row<T>::columns > 0) shape.push_back(Row<T>::columns);
  py::array result = py::array_t<Scalar>(shape, reinterpret_cast<const Scalar*>(values.data()), owner);
  result.attr("setflags")(py::arg("write") = false);
  return result;
}

// The same of a vector that is given away.
template <class T>
py::array take(std::vector<T> values)
{
  auto kept = std::make_unique<std::vector<T>>(std::move(values));
  using Scalar = typename Row<T>::Scalar;
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(kept->size())};
  if (Row<T>::columns > 0) shape.push_back(Row<T>::columns);
  const auto* data = reinterpret_cast<const Scalar*>(kept->data());
  py::capsule owner(kept.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  kept.release();
  return py::array_t<Scalar>(shape, data, owner);
}

inline void require_shape(const py::array& a, py::ssize_t columns, const std::string& name)
{
  const bool fits = columns == 0 ? a.ndim() == 1 : a.ndim() == 2 && a.shape(1) == columns;
  if (!fits)
    wrong(name + " has to be an array of shape (n" + (columns == 0 ? "," : ", " + std::to_string(columns)) +
          ")");
}

inline void require_finite(const double* first, std::size_t n, const char* name)
{
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(first[i])) wrong(std::string(name) + " holds a number that is not finite");
}

// The rows of an array as a range of C++ objects, in place where they are aligned for them.
template <class T>
class Rows {
public:
  using Scalar = typename Row<T>::Scalar;
  using Array = py::array_t<Scalar, py::array::c_style | py::array::forcecast>;

  Rows(Array array, const char* name) : array_(std::move(array))
  {
    require_shape(array_, Row<T>::columns, name);
    size_ = static_cast<std::size_t>(array_.shape(0));
    first_ = reinterpret_cast<const T*>(array_.data());
    if (reinterpret_cast<std::uintptr_t>(array_.data()) % alignof(T) == 0) return;
    copy_.resize(size_);
    const Scalar* from = array_.data();
    std::copy(from, from + array_.size(), reinterpret_cast<Scalar*>(copy_.data()));
    first_ = copy_.data();
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  const T* begin() const { return first_; }
  const T* end() const { return first_ + size_; }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return first_[i]; }
  const Scalar* data() const { return reinterpret_cast<const Scalar*>(first_); }
  std::vector<T> vector() const { return std::vector<T>(begin(), end()); }

private:
  Array array_;
  std::vector<T> copy_;
  const T* first_;
  std::size_t size_;
};

// A part of rows, for functions of the package that take ranges.
template <class T>
struct Span {
  const T *first, *last;
  const T* begin() const { return first; }
  const T* end() const { return last; }
};

// A new array of Python for n rows of C++ objects, and where they are written to.
template <class T>
std::pair<py::array, T*> rows_to_fill(std::size_t n)
{
  static_assert(alignof(T) <= alignof(double), "numpy aligns for scalars only");
  using Scalar = typename Row<T>::Scalar;
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(n)};
  if (Row<T>::columns > 0) shape.push_back(Row<T>::columns);
  py::array_t<Scalar> array(shape);
  return {array, reinterpret_cast<T*>(array.mutable_data())};
}

} // namespace simple_manifolds_python

#endif // SIMPLE_MANIFOLDS_PYTHON_ARRAYS_H
