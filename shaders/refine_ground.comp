// refine on a ground: what the samples listed for them leave of the places (docs/design.md,
// section 4, "exact with a field").
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/prelude.h"

#ifdef ENTRY_split
BINDINGS(StripArguments, SPLIT_BINDINGS)
#include "bodies/ground.h"
#include "bodies/split.h"
ENTRY(split, serve_split, StripArguments, SPLIT_BINDINGS)
#endif

#ifdef ENTRY_cut_on_ground
BINDINGS(StripArguments, CUT_ON_GROUND_BINDINGS)
#include "bodies/remnants.h"
#include "bodies/cut_on_ground.h"
ENTRY(cut_on_ground, serve_cut_on_ground, StripArguments, CUT_ON_GROUND_BINDINGS)
#endif

#ifdef ENTRY_cut_several
BINDINGS(StripArguments, CUT_SEVERAL_BINDINGS)
#include "bodies/remnants.h"
#include "bodies/cut_several.h"
ENTRY(cut_several, serve_cut_several, StripArguments, CUT_SEVERAL_BINDINGS)
#endif

#ifdef ENTRY_keep_on_ground
BINDINGS(StripArguments, KEEP_ON_GROUND_BINDINGS)
#include "bodies/kept_piece.h"
#include "bodies/keep_on_ground.h"
ENTRY(keep_on_ground, serve_keep_on_ground, StripArguments, KEEP_ON_GROUND_BINDINGS)
#endif

#ifdef ENTRY_keep_several
BINDINGS(StripArguments, KEEP_SEVERAL_BINDINGS)
#include "bodies/remnants.h"
#include "bodies/kept_piece.h"
#include "bodies/keep_several.h"
ENTRY(keep_several, serve_keep_several, StripArguments, KEEP_SEVERAL_BINDINGS)
#endif

#ifdef ENTRY_measure
BINDINGS(StripArguments, MEASURE_BINDINGS)
#include "bodies/ground.h"
#include "bodies/measure.h"
ENTRY(measure, serve_measure, StripArguments, MEASURE_BINDINGS)
#endif
