#include "core/measured/measured_file.h"

#include <fstream>
#include <iterator>

#include "core/base/input_error.h"

namespace asperity {

MeasuredFile readMeasuredFile(const std::filesystem::path& file, const ReadingChoices&,
                              const std::stop_token&, const ReadingProgress&) {
  throw InputError(file.string(), "", "cannot be read yet");
}

MeasuredFile readMeasuredBytes(std::string_view, const std::string& name, const ReadingChoices&,
                               const std::stop_token&, const ReadingProgress&) {
  throw InputError(name, "", "cannot be read yet");
}

}  // namespace asperity
