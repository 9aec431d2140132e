// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_NEEDS_VECTOR_H
#define CGAL_NEEDS_VECTOR_H

inline std::vector<int> empty() { return {}; }

#endif // CGAL_NEEDS_VECTOR_H
