// Measures that nobody took, from those that were.
#pragma once

#include "geometry/body/measure_values.h"

namespace toile {

/// What a mannequin needs and `given` lacks. It is filled in from height, bust and hip, and from
/// other measures where they are given. Throws Error, naming what is missing, unless height, bust
/// and hip are given. For the height, waist_to_floor, waist_height, inside_leg, crotch_height or
/// cervicale_height may stand.
///
/// Heights are shares of the stature [Drillis & Contini 1966; ANSUR II 2012]. A child's shares go
/// over into an adult's from 1.00 m to 1.60 m. Necks follow the chest [EN 13402-3]. Other girths
/// follow straight lines through the sizes that European makers publish. All are means: a person
/// may be 5 % off, a waist 10 %.
MeasureValues filled_measures(const MeasureValues& given, FigureType figure);

/// A woman's underbust in metres for a bust in metres and a cup. Cups are AA to H in steps of 2 cm
/// [EN 13402-3]. The bust is 10 to 12 cm more for AA, and 12 to 14 cm more for A. Throws Error for
/// another cup.
double underbust_of_cup(double bust, const std::string& cup);

}  // namespace toile
