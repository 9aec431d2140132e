/// \ingroup PkgSimpleManifoldsConcepts
/// \cgalConcept
///
/// The concept `SimpleManifoldsVisitor` describes the object that the long functions of the package tell
/// what they do: it shows progress, measures phases, or cancels. It is passed by `std::ref` as the named
/// parameter `visitor`.
///
/// Phases follow one another and do not nest. All members are called from the thread that called the
/// function. To cancel, throw from any member: the exception passes through the function, and the caller's
/// data are as they were before the call.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`CGAL::Simple_manifolds::Default_visitor`}
/// \cgalHasModelsEnd
class SimpleManifoldsVisitor {
public:
  /// \name Operations
  /// @{

  /// A phase starts. `name` is a string literal such as `"decimate"`.
  void start_phase(const char* name);

  /// The share of the running phase that is done, in \f$ [0,1] \f$; does not decrease within a phase.
  void progress(double fraction);

  /// The running phase ended.
  void end_phase();

  /// @}
};
