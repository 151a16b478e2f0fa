#include "ui/window/figures/claim_text.h"

#include <algorithm>
#include <cmath>

#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

QString verdictText(const Claim& claim) {
  if (claim.holds == Verdict::OnlyForScheme)
    return QString::fromStdString(
        filled(Words::tr("only for scheme %1"), {translated(claim.scheme)}));
  if (claim.holds == Verdict::Undecided) return QString::fromStdString(Words::tr("undecided"));
  return QString::fromStdString(claim.holds == Verdict::Yes ? Words::tr("yes") : Words::tr("no"));
}

QString estimateText(const Estimate& estimate) {
  const double error = estimate.standardError;
  const double size = std::max(std::abs(estimate.value), error);
  if (!std::isfinite(estimate.value) || !std::isfinite(error) || error <= 0)
    return readingLabel(estimate.value);
  if (size >= 1e5 || size < 1e-3) {  // one power of ten for both numbers
    const int power = static_cast<int>(std::floor(std::log10(size)));
    const double unit = std::pow(10, power);
    return '(' + estimateText({estimate.value / unit, error / unit}) + QStringLiteral(")×") +
           QString::fromStdString(powerOfTen(power));
  }
  // An uncertainty that begins with 1 has two digits, any other one has one.
  const int exponent = static_cast<int>(std::floor(std::log10(error)));
  const int digits = error / std::pow(10, exponent) < 1.95 ? 1 - exponent : -exponent;
  const int decimals = std::clamp(digits, 0, 6);
  return inLanguage(QString::number(estimate.value, 'f', decimals).replace('-', u'−') +
                    QStringLiteral(" ± ") + QString::number(error, 'f', decimals));
}

}  // namespace asperity
