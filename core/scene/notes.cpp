#include "core/scene/notes.h"

#include <array>

#include "core/base/text.h"

namespace asperity {
namespace {

struct NoteText {
  std::string_view word;
  std::string_view sentence;
};

constexpr std::array<NoteText, kNotes> kTexts{{
    {"slope_above_0.3",
     "the rms slope of the line is above 0.3: the model assumes small slopes, so its friction is "
     "only an estimate"},
    {"few_contacts",
     "few contacts carry the load: results depend on the single summits of this line and on its "
     "period"},
    {"extrapolated_material",
     "sliding excites frequencies outside of those that the elastomer was measured at"},
    {"extrapolated_temperature",
     "the temperature lies outside of those that the elastomer was measured at"},
    {"strain_beyond_measured", "strains are larger than those that the elastomer was measured at"},
    {"seam_jump",
     "the end of the profile does not meet its beginning: the period repeats with a step, which "
     "carries load like a sharp edge; surface.seam mirror or blend avoids it"},
    {"spikes",
     "single points of the measured surface stand far out of their neighbours, like spikes, and "
     "carry load: where they are errors of the measurement, surface.outliers=6 replaces them"},
    {"coarse_heights",
     "the heights of rows have steps about as large as neighbours differ, and the lines are too "
     "steep by these steps: measure in finer steps, or remove short waves by "
     "surface.short_wave_cut"},
    {"round_form",
     "the profile is part of a circle, as of a tyre or a roller, which a parabola does not follow, "
     "and this form carries load: measure a shorter piece, or remove it by surface.long_wave_cut"},
    {"few_independent_rows",
     "the rows of the surface are so few, or so much alike, that they count as fewer than about "
     "ten "
     "independent lines: the standard error of the mean is only roughly known"},
    {"fast_enough_to_heat",
     "so much power is dissipated that the elastomer would become warmer, which is not computed"},
    {"unresolved_friction",
     "too few elements are in contact for the tangential force, which is the error of their sum"},
    {"faster_than_tested",
     "the velocity is above 1000 m/s: real elastomers are not slid so fast, and the model leaves "
     "out the inertia that would then count"},
}};

}  // namespace

std::string_view noteWord(Note note) {
  return kTexts[static_cast<std::size_t>(note)].word;
}

Message noteSentence(Note note) {
  return Message(kTexts[static_cast<std::size_t>(note)].sentence);
}

std::vector<Note> NoteSet::list() const {
  std::vector<Note> notes;
  for (std::size_t i = 0; i < kNotes; ++i)
    if (has(static_cast<Note>(i))) notes.push_back(static_cast<Note>(i));
  return notes;
}

std::string NoteSet::words() const {
  std::string text;
  for (const Note note : list()) appendItem(text, noteWord(note), " ");
  return text;
}

}  // namespace asperity
