// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_NOT_INLINE_H
#define CGAL_NOT_INLINE_H

int answer() { return 42; }

#endif // CGAL_NOT_INLINE_H
