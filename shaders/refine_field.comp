// refine with a radius field: what the samples listed for them leave of the places (docs/design.md,
// section 4, "exact with a field").
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_split
BINDINGS(StripArguments, SPLIT_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/split.h"
ENTRY(split, serve_split, StripArguments, SPLIT_BINDINGS)
#endif

#ifdef ENTRY_cut_places
BINDINGS(StripArguments, CUT_PLACES_BINDINGS)
#include "bodies/exact/remnants.h"
#include "bodies/exact/touches.h"
#include "bodies/exact/cut_places.h"
ENTRY(cut_places, serve_cut_places, StripArguments, CUT_PLACES_BINDINGS)
#endif

#ifdef ENTRY_cut_halves
BINDINGS(StripArguments, CUT_HALVES_BINDINGS)
#include "bodies/exact/remnants.h"
#include "bodies/exact/touches.h"
#include "bodies/exact/cut_halves.h"
ENTRY(cut_halves, serve_cut_halves, StripArguments, CUT_HALVES_BINDINGS)
#endif

#ifdef ENTRY_cut_uneven
BINDINGS(StripArguments, CUT_UNEVEN_BINDINGS)
#include "bodies/exact/remnants.h"
#include "bodies/exact/touches.h"
#include "bodies/exact/uneven_strip.h"
#include "bodies/exact/cut_uneven.h"
ENTRY(cut_uneven, serve_cut_uneven, StripArguments, CUT_UNEVEN_BINDINGS)
#endif

#ifdef ENTRY_cut_several
BINDINGS(StripArguments, CUT_SEVERAL_BINDINGS)
#include "bodies/exact/remnants.h"
#include "bodies/exact/uneven_strip.h"
#include "bodies/exact/several.h"
#include "bodies/exact/cut_several.h"
ENTRY(cut_several, serve_cut_several, StripArguments, CUT_SEVERAL_BINDINGS)
#endif

#ifdef ENTRY_keep_places
BINDINGS(StripArguments, KEEP_PLACES_BINDINGS)
#include "bodies/exact/strip.h"
#include "bodies/exact/kept_piece.h"
#include "bodies/exact/keep_places.h"
ENTRY(keep_places, serve_keep_places, StripArguments, KEEP_PLACES_BINDINGS)
#endif

#ifdef ENTRY_keep_halves
BINDINGS(StripArguments, KEEP_HALVES_BINDINGS)
#include "bodies/exact/strip.h"
#include "bodies/exact/kept_piece.h"
#include "bodies/exact/keep_halves.h"
ENTRY(keep_halves, serve_keep_halves, StripArguments, KEEP_HALVES_BINDINGS)
#endif

#ifdef ENTRY_keep_uneven
BINDINGS(StripArguments, KEEP_UNEVEN_BINDINGS)
#include "bodies/exact/strip.h"
#include "bodies/exact/kept_piece.h"
#include "bodies/exact/uneven_strip.h"
#include "bodies/exact/keep_uneven.h"
ENTRY(keep_uneven, serve_keep_uneven, StripArguments, KEEP_UNEVEN_BINDINGS)
#endif

#ifdef ENTRY_keep_several
BINDINGS(StripArguments, KEEP_SEVERAL_BINDINGS)
#include "bodies/exact/remnants.h"
#include "bodies/exact/uneven_strip.h"
#include "bodies/exact/several.h"
#include "bodies/exact/kept_piece.h"
#include "bodies/exact/keep_several.h"
ENTRY(keep_several, serve_keep_several, StripArguments, KEEP_SEVERAL_BINDINGS)
#endif

#ifdef ENTRY_measure
BINDINGS(StripArguments, MEASURE_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/measure.h"
ENTRY(measure, serve_measure, StripArguments, MEASURE_BINDINGS)
#endif
