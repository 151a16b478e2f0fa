// What people read about a parameter, in the language of the window: its label, its values and the
// sentences of its tooltips; and how the filter of the panel finds it by these words. The names of
// these texts belong to ParameterRow, which shows them. Pure; GUI thread.
#pragma once

#include <QString>
#include <QStringList>

#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "ui/panels/number_text.h"

namespace asperity {

/// Returns the name of a parameter.
QString labelText(const Parameter& parameter);

/// Returns "shear modulus G" as HTML; a label that ends with its symbol, "constant C1", has it
/// once.
QString labelWithSymbol(const Parameter& parameter);

/// Returns a text in which the keys of parameters are replaced by their quoted labels, and their
/// values by those that the rows show: "“temperature” = 293.15 K".
QString withLabels(const QString& text);

/// Returns an error with the labels of parameters instead of their keys, and without the name of an
/// option. An error in a file names the key that is written there.
QString errorWithLabel(const InputError& error);

/// Returns whether all words are found in the parameter's label, its key, its symbol or its unit.
/// inSentence: or in the sentence that describes it.
bool isFound(const Parameter& parameter, const QStringList& words, bool inSentence = false);

/// Returns a value as the row shows it.
UnitText shownText(const Parameter& parameter, const ParameterValue& value);
/// Returns the same in one text, "293.15 K".
QString textWithUnit(const Parameter& parameter, const ParameterValue& value);

/// Returns what the reset button does: the default's arms in words, any other value as its row
/// shows it.
QString resetText(const Parameter& parameter, const ParameterValue& initial);

/// Returns the sentence of the parameter and its formula for the elements of a scene.
QString explanationText(const Parameter& parameter, Rheology rheology);

/// Returns the tooltip of the label: what the parameter is, with formula, sentence, key and range.
QString parameterTip(const Parameter& parameter, Rheology rheology);

/// Whether a row has a slider: one that is hidden still makes its steps with the keys.
enum class SliderUse { None, Hidden, Visible };

/// Returns the tooltip of the control: what the parameter is and how the control is used.
QString controlTip(const Parameter& parameter, Rheology rheology, SliderUse slider);

}  // namespace asperity
