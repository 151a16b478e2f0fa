// Asks a person for a file to write. GUI thread; cannot fail.
#pragma once

#include <QString>

class QWidget;

namespace asperity {

/// Empty where none was chosen. A name without an ending gets the first one of the filter that is
/// chosen in the dialog, before it is asked whether the file may be replaced. `name` is proposed,
/// with or without a folder; `filters` as for QFileDialog, separated by ";;".
QString askSaveFile(QWidget* parent, const QString& title, const QString& name,
                    const QString& filters);

}  // namespace asperity
