#include "core/base/input_error.h"

namespace asperity {

Message TextError::withNames(const std::vector<std::string>& names, Message message) {
  Message whole = std::move(message);
  for (auto name = names.rbegin(); name != names.rend(); ++name)
    if (!name->empty()) whole = asperity::message("{}: {}", *name, whole);
  return whole;
}

Message errorMessage(const std::exception& error) {
  const auto* text = dynamic_cast<const TextError*>(&error);
  return text ? TextError::withNames(text->about(), text->message()) : Message::name(error.what());
}

InputError unknownExtension(const std::string& file, const std::string& extension,
                            std::initializer_list<std::string_view> known) {
  if (!extension.empty()) return {file, "", notOneOf("'" + extension + "'", {known})};
  return {file, "",
          message("the file name has no extension; allowed is {}", namesWithCommas({known}))};
}

}  // namespace asperity
