// The texts of lessons as people read them: markup as rich text, numbers with their units, in the
// language of the window. Pure once the language is chosen; any thread.
#pragma once

#include <QString>

#include "core/lesson/lesson_answers.h"

namespace asperity {

/// Returns a text in the current language.
const std::string& shown(const LessonText& text);
QString plainText(const LessonText& text);
/// Returns the same with its quantities and formulas kept on one line each.
QString lineText(const LessonText& text);

/// Returns a title as part of the name of a file; empty where it has no letter for it.
QString fileNamePart(const LessonText& title);

/// Returns the date and time of results as the language of the window writes them; a text that is
/// no ISO date stays.
QString dateText(const std::string& date);

/// Returns HTML of paragraphs and lists: "*word*" in italics, "**word**" in bold, "- " items.
/// Everything else is plain text.
QString lessonHtml(const std::string& text);

/// Returns a number as a sentence has it: "1.97", "0.25 µm".
std::string numberInWords(const LessonNumber& number);

/// Returns the height and the place of a point: "0.25 at 10 mm/s".
QString pointInWords(const LessonNumber& height, const LessonNumber& place);

/// Returns the right answer with its tolerance: "1.97 (right within ±10 %)", the text of a
/// choice.
QString answerInWords(const LessonPrediction& prediction, const LessonAnswer& answer);

/// Returns how near an answer has to be to be right: "An answer within 20 % of the right one
/// counts."; of a point "A height within a factor of 1.5 and a place within a factor of 2 count as
/// right."; empty for a choice.
QString toleranceText(const LessonPrediction& prediction);

/// Returns HTML of a text shown after the answer, with the values in it.
QString lessonHtml(const LessonText& text, const LessonPrediction& prediction,
                   const LessonAnswer& answer, const GivenAnswer& given);

/// Returns a text, as rich text, on whether the answer is right, what the student answered and what
/// the program finds. Without an answer of the student it has only the computed one.
QString verdictText(const LessonPrediction& prediction, const LessonAnswer& answer,
                    const GivenAnswer& given, bool isRight);

}  // namespace asperity
