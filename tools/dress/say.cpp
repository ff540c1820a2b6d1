#include "tools/dress/say.h"

#include <cmath>
#include <iomanip>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>

#include "cloth/judge/constants.h"
#include "cloth/judge/drafted.h"
#include "cloth/scene/constants.h"
#include "io/floor_height.h"
#include "io/text.h"
#include "tools/dress/extra_offset.h"
#include "tools/report.h"

namespace toile {

namespace {

/// Metres by which cloth is held farther off the body than its offset, from which on it is said.
constexpr double worth_saying = 0.002;
/// Strain (99th percentile, off the seams) that no woven is worn at.
constexpr double suspicious_strain = 0.1;
/// Girths of the body: a garment that is nowhere nearer is too wide. Of 19 random garments the
/// widest has 1.17 at its nearest level; the T-shirt cut at 1.4 has 1.50. Half of what is beyond 1
/// would name none of the 19, double would miss the T-shirt [measured, 25 mm].
constexpr double too_wide_factor = 1.35;
/// Metres between a panel and its mirror image, on average, from which on it hangs crooked.
constexpr double asymmetric = 0.02;
/// Metres of border: a smaller hole than this is meant to be one.
constexpr double worth_an_opening = 0.05;
/// Metres, on average: an attachment that stands farther off was not held.
constexpr double not_held = 0.02;

std::string percent(double fraction) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << 100 * fraction << " %";
  return text.str();
}

/// What, where and how far the most strained of the regions is, and how many others there are.
std::string text_of(const std::vector<TightRegion>& regions) {
  const TightRegion& most = regions.front();
  std::ostringstream line;
  line << std::fixed << std::setprecision(1) << "panel " << most.panel << ", " << 100 * most.height
       << " cm above the ground, " << 1e4 * most.area << " cm2, is strained by up to "
       << percent(most.largest) << " along the " << (most.along_warp ? "warp" : "weft")
       << ", where " << 100 * most.missing << " cm are missing";
  if (const std::size_t others = regions.size() - 1; others > 0) {
    line << "; other regions: " << others;
  }
  return line.str();
}

void say_release(const ReleaseReport& release, DressLog& log) {
  std::ostringstream line;
  line << std::fixed << std::setprecision(2) << "let go for " << release.seconds
       << " s, half of its nodes move less than " << 1000 * release.all.median
       << " mm, 99 % less than " << 1000 * release.all.p99 << " mm, all less than "
       << 1000 * release.all.max << " mm";
  log.say(line.str());
  if (release.stays()) return;
  log.warn({"unstable", "",
            "the garment does not stay where it was draped: let go, a hundredth of its nodes "
            "moves 2 mm and more; a smaller --residual can bring it nearer to rest"});
}

/// A line for each, and a warning for one that did not hold.
void say_attachments(const std::vector<AttachmentMeasurement>& attachments, DressLog& log) {
  for (const AttachmentMeasurement& measured : attachments) {
    if (!measured.used) continue;
    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << measured.name << " attached to " << measured.to
         << ": " << 1000 * measured.off_mean
         << (measured.always ? " mm off, carries " : " mm off when it was let go");
    if (measured.always) line << measured.pull.norm() << " N";
    log.say(line.str());
    if (measured.off_mean < not_held) continue;
    std::ostringstream warning;
    warning << std::fixed << std::setprecision(1) << "attachment " << measured.name << " stands "
            << 100 * measured.off_mean << " cm off its " << measured.to
            << ": the cloth does not reach, or needs more than its 'max_N'";
    log.warn({"attachment_off", measured.name, warning.str()});
  }
}

/// Where it is too small or too wide, and how far it is from where it was drafted to lie.
void warn_of_fit(const Judgement& judgement, DressLog& log) {
  const Fit& fit = judgement.fit;
  for (const FitLevel& level : fit.levels) {
    log.warn({"too_small", level.level, text_of(level)});
  }
  if (fit.nearest && fit.nearest->as_cut > too_wide_factor * fit.nearest->body) {
    log.warn({"too_wide", fit.nearest->level,
              "too wide: it is nowhere nearer to the trunk than at the " + fit.nearest->level +
                  ", cut " + centimetres(fit.nearest->as_cut, 1) + " for " +
                  centimetres(fit.nearest->body, 1) + " where it was drafted to lie"});
  }
  for (const GarmentLevel& level : judgement.levels) {
    if (judgement.worn.slid || !left_its_place(level, judgement.height_error)) continue;
    const bool is_up = *level.risen() > 0;
    log.warn({is_up ? "rode_up" : "slid_down", level.name,
              "the " + level.name + " hangs " + centimetres(std::abs(*level.risen()), 1) +
                  (is_up ? " higher" : " lower") + " than drafted, " +
                  centimetres(*level.drafted, 1) + " above the floor: it " +
                  (is_up ? "rides up" : "slides down")});
  }
  if (const std::optional<Slid>& slid = judgement.worn.slid; slid && slid->is_far()) {
    log.warn({slid->down > 0 ? "slid_down" : "rode_up", "torso", "the garment " + text_of(*slid)});
  }
}

/// "panel 'left_sleeve' lies 4.6 cm lower than its mirror image 'right_sleeve', ..."
std::string text_of(const Asymmetry& asymmetry) {
  const bool is_lower = asymmetry.height > asymmetry.across;
  return "panel '" + asymmetry.panel + "' lies " + centimetres(asymmetry.crooked(), 1) +
         (is_lower ? " lower" : " farther out") + ", on average, than " +
         (asymmetry.panel == asymmetry.mirror ? "its own mirror image"
                                              : "its mirror image '" + asymmetry.mirror + "'") +
         ", though the pattern is symmetric: it hangs crooked, or the body is not symmetric";
}

/// Why the verdict is what it is, where that takes a name.
void warn_of_verdict(const DressResult& result, const Judgement& judgement, DressLog& log) {
  std::ostringstream line;
  line << std::fixed << std::setprecision(1);
  const char* separator = "";
  for (const OpenSeam& seam : judgement.garment.seams.open_seams) {
    line << separator << seam.name << " (" << 100 * seam.gap << " cm)";
    separator = ", ";
  }
  if (!line.str().empty()) {
    log.warn({"seams_open", judgement.garment.seams.open_seams.front().name,
              "these seams could not be closed; how far they stand open: " + line.str()});
  }
  std::ostringstream tight;
  tight << std::fixed << std::setprecision(1);
  separator = "";
  for (const TightSeam& seam : result.tight_seams) {
    tight << separator << seam.name << " (" << 100 * seam.missing << " cm)";
    separator = ", ";
  }
  if (!result.tight_seams.empty()) {
    log.warn({"too_tight", result.tight_seams.front().name,
              "too tight: closing these seams takes more than a hand's pull, " +
                  std::to_string(std::lround(hand_pull)) +
                  " N/m (less for soft fabrics); what is missing at each: " + tight.str()});
  }
  const std::vector<TightRegion>& overstretched = judgement.garment.overstretched;
  if (!overstretched.empty()) {
    log.warn({"too_tight", overstretched.front().panel,
              "too tight: nobody wears cloth that is stretched by more than " +
                  fixed_number(100 * max_worn_strain, 0) + " %: " + text_of(overstretched)});
  }
  const WearFindings& worn = judgement.worn;
  if (!worn.is_checked) {
    log.warn({"not_checked", "",
              "where the garment is worn is not checked: neither joints, parts, labels, names nor "
              "openings tell where it belongs"});
  }
  // Where seams are open, every panel has an opening.
  for (const Opening& opening : worn.openings) {
    if (judgement.garment.seams.open > 0) break;
    if (opening.limbs.any() || opening.is_cut_out || opening.length < worth_an_opening) continue;
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << "an opening of " << 100 * opening.length
         << " cm, " << floor_height(opening.middle.y())
         << ", has nothing in it: a cut-out, or a stitch is missing";
    log.warn({"empty_opening", "", text.str()});
  }
  for (const Slit& slit : judgement.slits) {
    if (judgement.garment.seams.open > 0) break;
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << "a slit of " << 100 * slit.length
         << " cm between panel '" << slit.panel_a << "' and panel '" << slit.panel_b << "', "
         << floor_height(slit.tip.y()) << ": a vent, or a seam is left open";
    log.warn({"open_edges", slit.panel_a, text.str()});
  }
  std::set<std::string> cut_short;
  for (const BandEnd& end : judgement.band_ends) {
    if (judgement.garment.seams.open > 0) break;
    if (!cut_short.insert(end.band).second) continue;
    log.warn({"open_edges", end.band,
              "panel '" + end.band + "' ends " + floor_height(end.at.y()) +
                  ", and the edge of panel '" + end.goes_on +
                  "' goes on without it: the rest of the band is missing, or its end is not sewn"});
  }
  for (const Opening& opening : worn.openings) {
    if (judgement.garment.seams.open > 0) break;
    const LimbsThrough& limbs = opening.limbs;
    if (limbs.left_leg && limbs.right_leg && limbs.left_arm != limbs.right_arm) {
      const std::string side = limbs.left_arm ? "left" : "right";
      std::string text = "the " + side;
      text += " armhole and the hem are one opening: a seam is left open at the ";
      log.warn({"open_edges", side + "_arm", text + side + " side"});
    }
    if (!is_too_small(opening, opening.length)) continue;
    const bool is_neck = limbs == through_neckline;
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << "nobody gets into this: the "
         << (is_neck ? "neckline" : "edge around the trunk") << ", "
         << floor_height(opening.middle.y()) << ", opens to " << 100 * opening.length << " cm, the "
         << (is_neck ? "head" : "body") << " has " << 100 * opening.passes
         << " cm: a closure is left out, or too much is sewn shut";
    log.warn({"opening_too_small", is_neck ? "neck" : "trunk", text.str()});
  }
  if (worn.bare) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << "it leaves " << 100 * (1 - worn.bare->share)
         << " % of the way around the trunk bare, " << floor_height(worn.bare->height)
         << ": its neckline or armholes are deep, or a panel is missing";
    log.warn({"open_edges", "torso", text.str()});
  }
  for (const std::string& panel : worn.turned) {
    log.warn(
        {"upside_down", panel,
         "panel '" + panel +
             "' hangs the other way up than the pattern places it: turn it about, or check the "
             "direction of its stitches"});
  }
  if (judgement.asymmetry && judgement.asymmetry->crooked() > asymmetric) {
    log.warn({"asymmetric", judgement.asymmetry->panel, text_of(*judgement.asymmetry)});
  }
  for (const std::string& panel : judgement.on_floor) {
    log.warn({"hem_on_floor", panel,
              "panel '" + panel + "' lies on the floor: it is too long, or it slid down"});
  }
  if (worn.misplaced) {
    log.warn({"misplaced", name_of(worn.misplaced->part),
              "the garment is not worn where it belongs, or not as it should be; wanted: " +
                  worn.misplaced->should_be + "; found: " + worn.misplaced->at +
                  "; check where its panels start, and what they are sewn to"});
  }
  for (const BodyPart part : worn.unwrapped) {
    log.warn({"unwrapped", name_of(part),
              "the garment does not go around " + name_of(part) +
                  ": check where the panels of that part are placed, and what they are sewn to"});
  }
}

}  // namespace

void DressLog::warn(const Warning& warning) {
  CommonSettings::warn(warning.text);
  warnings_.push_back(warning);
}

std::vector<Warning> DressLog::take_warnings() { return std::exchange(warnings_, {}); }

void say_certificate(const Certificate& certificate, DressLog& log) {
  const std::size_t count = certificate.frames().size();
  if (const std::optional<int> first = certificate.clean_from()) {
    log.say("certified: " + std::to_string(count) + " frames, clean from frame " +
            std::to_string(*first) + " (" + certificate.frames()[*first].stage + ") on");
  }
  if (certificate.stayed_clean()) return;
  std::size_t last = count;
  while (last > 0 && certificate.frames()[last - 1].clean()) --last;
  if (last == 0) return;
  const FrameCheck& frame = certificate.frames()[last - 1];
  log.warn({"not_certified", "",
            "not certified: the state did not stay free of intersections; last in frame " +
                std::to_string(last - 1) + " (" + frame.stage + "): " + std::to_string(frame.body) +
                " with the body, " + std::to_string(frame.self) + " with itself, " +
                std::to_string(frame.layers) + " with layers below, " +
                std::to_string(frame.inside) + " pieces inside the body"});
}

void say_places(const WornLayer& worn, DressLog& log) {
  if (worn.places.empty()) return;
  log.say(worn.place_reason + "; they stand by their seams, change it with --place:");
  for (const FoundPlace& place : worn.places) log.say("  " + text_of(place));
}

void say_positions(const Placement& placement, DressLog& log) {
  for (const PositionedPanel& panel : placement.positioned) {
    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << "panel " << panel.panel;
    if (panel.rolled) {
      line << " is rolled" << (panel.bent ? " along the bend of its part" : "") << ", radius "
           << 100 * panel.distance << " cm, gap " << 100 * panel.gap << " cm";
    } else {
      line << " stands " << 100 * panel.distance << " cm from the bones";
    }
    log.say(line.str());
  }
  for (const auto& [part, angle] : placement.turned) {
    log.say("the sleeve of " + name_of(part) + " was turned by " +
            std::to_string(std::lround(angle * 180 / std::numbers::pi)) +
            " degrees, to run down the arm");
  }
  for (const auto& [panel, distance] : placement.moved_clear) {
    std::ostringstream line;
    line << "panel " << panel << " stood through the body or another panel, and was moved out by "
         << std::lround(100 * distance) << " cm";
    log.say(line.str());
  }
}

void say_result(const DressResult& result, const Judgement& judgement, DressLog& log) {
  const GarmentMeasurements& measured = judgement.garment;
  std::ostringstream residual;
  residual << std::setprecision(2) << result.residual.median << " median, " << result.residual.rms
           << " rms";
  log.say("seams: " + std::to_string(measured.seams.sewn) + " sewn, " +
          std::to_string(measured.seams.open) +
          " open; intersections: " + std::to_string(judgement.body_intersections) +
          " with the body, " + std::to_string(judgement.self_intersections) + " with itself, " +
          std::to_string(judgement.layer_intersections) + " with layers below");
  log.say("strain off the seams: " + percent(measured.strain_off_seams.p99) +
          " (99th percentile); residual in node weights: " + residual.str());
  if (const ExtraOffset extra = extra_offset_of(result.extra_offset); extra.max > worth_saying) {
    std::ostringstream line;
    line << std::setprecision(2) << "held up to " << 1000 * extra.max
         << " mm farther off the body at " << extra.nodes
         << " nodes, whose triangles span something sharp: a finer mesh comes nearer";
    log.say(line.str());
  }
  say_attachments(result.attachments, log);
  if (result.tight_regions && !result.tight_regions->regions.empty()) {
    log.say("beyond the strain limit: " + text_of(result.tight_regions->regions));
  }
  if (result.release) say_release(*result.release, log);
  for (const WrapMeasurement& wrap : judgement.wraps) {
    log.say("wraps " + name_of(wrap.part) + ": " + percent(wrap.fraction));
  }
  warn_of_fit(judgement, log);
  if (result.placement.points_inside > 0) {
    log.warn({"starts_inside", "",
              std::to_string(result.placement.points_inside) +
                  " points of the panels start inside the body, or a layer on it: place the panels "
                  "clear of it"});
  }
  if (measured.strain_off_seams.p99 > suspicious_strain) {
    log.warn({"strained", "",
              "the cloth is strained by " + percent(measured.strain_off_seams.p99) +
                  " in places: the garment is too small for this body, or caught on it"});
  }
  warn_of_verdict(result, judgement, log);
  log.say(verdict_line(to_string(judgement.verdict), text_of(judgement.fit)));
}

void say_pressing(const CoupledResult& coupled, const std::vector<std::string>& names,
                  DressLog& log) {
  for (const LayerContact& pressing : coupled.contacts) {
    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << names[pressing.outer] << " presses on "
         << names[pressing.inner] << " with " << pressing.force << " N, "
         << pressing.force / pressing.area << " Pa where they touch";
    log.say(line.str());
  }
}

}  // namespace toile
