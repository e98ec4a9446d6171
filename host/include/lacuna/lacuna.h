// All of Lacuna's public API that needs the library alone. Link lacuna.
#pragma once

#include <lacuna/cancel.h>
#include <lacuna/domain.h>
#include <lacuna/errors.h>
#include <lacuna/inks.h>
#include <lacuna/many.h>
#include <lacuna/order.h>
#include <lacuna/relax.h>
#include <lacuna/run.h>
#include <lacuna/sample.h>
#include <lacuna/space.h>
#include <lacuna/threshold_mask.h>
#include <lacuna/verify.h>
#include <lacuna/version.h>
