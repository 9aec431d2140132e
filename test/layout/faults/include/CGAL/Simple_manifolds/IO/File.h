// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_FILE_H
#define CGAL_SIMPLE_MANIFOLDS_IO_FILE_H

#include <CGAL/Simple_manifolds/correspondence/Base.h>

#endif // CGAL_SIMPLE_MANIFOLDS_IO_FILE_H
