// How sure a body's measures are.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/measures.h"

namespace toile {

/// Sets Measure::plus_minus of `measures`, which measure_body() took of this body.
///
/// It is the sum of two. The first is what a careful measurer may be off by [ISO 20685-1:2018]:
/// large girths 9 mm, others 4, lengths 5, heights 4. Of an angle it is half a degree. The second
/// is the most by which the measure moves on three other bodies. Two of them lean by a degree,
/// forward and back, and one has half a millimetre of noise. A level that the body shows badly
/// moves far then. A measure that such a body does not have moves by 2 cm, or 2 degrees.
///
/// `body` and `name` are those of find_landmarks(). Costs three times find_landmarks() and
/// measure_body(), side by side.
void estimate_errors(const TriangleMesh& body, const std::string& name,
                     std::vector<Measure>& measures);

}  // namespace toile
