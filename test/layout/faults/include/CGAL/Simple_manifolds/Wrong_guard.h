// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_OTHER_GUARD_H
#define CGAL_SIMPLE_MANIFOLDS_OTHER_GUARD_H

#endif // CGAL_SIMPLE_MANIFOLDS_OTHER_GUARD_H
