// SPDX-License-Identifier: MIT
// Chemical elements live in base, as the atom table and trajectory files know them too.
#pragma once

#include "pliant/base/elements.hpp"
