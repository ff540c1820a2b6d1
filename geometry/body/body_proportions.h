// Measures that nobody took, from those that were.
#pragma once

#include "geometry/body/body_measures.h"

namespace toile {

/// The measures of `given` that a mannequin needs and that are not there, filled in from height,
/// bust and hip, and from others where they are given. Throws Error, naming what is missing, unless
/// height (or waist_to_floor, waist_height, inside_leg or crotch_height), bust and hip are given.
///
/// Heights are shares of the stature [Drillis & Contini 1966; ANSUR II 2012]. A child's shares go
/// over into an adult's from 1.00 m to 1.60 m. Girths follow the steps of size tables: EN 13402-3
/// for neck by chest, and for the others a straight line through two sizes of the tables that
/// European makers publish. They are means: a person may be 5 % off, a waist 10 %.
BodyMeasures filled_measures(const BodyMeasures& given, Figure figure);

/// A woman's underbust in metres for a bust and a cup of EN 13402-3: AA to H, in steps of 2 cm, AA
/// being 10 to 12 cm, A 12 to 14. Throws Error for another cup.
double underbust_of_cup(double bust, const std::string& cup);

}  // namespace toile
