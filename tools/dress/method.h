// The ways to dress that the command line offers, with the options of each.
#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>

#include "cloth/dressing/outfit.h"
#include "cloth/dressing/quality.h"

namespace toile {

struct DressMethod {
  std::string name;
  /// The preset that says how far it goes; none: a --residual, or a method without measured ones.
  std::optional<Quality> quality;
  OutfitMethod outfit;
};

/// Until the rest that `quality` stands for, which is one of the presets.
DressMethod relaxation_of(const Quality& quality);

/// --quality; where it is not given, the usual one, and with --release the standard. Throws
/// boost::program_options::error for what is no preset's name.
const Quality& read_quality(const boost::program_options::variables_map& given);

/// Adds --method, --strain-limit, --shear-limit, --quality, --residual and what belongs to one
/// method only. `usual` is the quality of who asks for none.
void add_method_options(boost::program_options::options_description& options, const Quality& usual);

/// Throws boost::program_options::error when an option belongs to a method that is not chosen.
void check_method_options(const boost::program_options::variables_map& given);

/// The method that was asked for, of layers that are `coupled` or not. Throws Error for values out
/// of range, and for a method that can't couple layers.
DressMethod read_method(const boost::program_options::variables_map& given, bool coupled);

/// --strain-limit, if it was given and is a fraction.
std::optional<double> read_strain_limit(const boost::program_options::variables_map& given);
/// --shear-limit, if it was given and is an angle: its sine.
std::optional<double> read_shear_limit(const boost::program_options::variables_map& given);

}  // namespace toile
