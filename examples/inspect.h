// What is in a file, and what the programs can do with it: map_mesh --inspect.

#ifndef SIMPLE_MANIFOLDS_EXAMPLES_INSPECT_H
#define SIMPLE_MANIFOLDS_EXAMPLES_INSPECT_H

#include "Command_line.h"

namespace tools {

/// Adds --inspect and --json.
void add_inspect_options(Command_line& options);

/// Whether INPUT is to be inspected, not mapped.
/// \throw Usage_error  when --json is given without --inspect
bool is_inspection(const Command_line& options);

/// Prints what is in INPUT, part by part, what is done to it when it is read and with --repair, and the command that
/// serves it: as a table, or as JSON. It succeeds for whatever can be read.
/// \return the exit status
int inspect(const Command_line& options);

} // namespace tools

#endif // SIMPLE_MANIFOLDS_EXAMPLES_INSPECT_H
