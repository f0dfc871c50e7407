#include "io/xml.hpp"

#include <algorithm>

#include "io/fail.hpp"

namespace unsliver::io {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

void skip_space(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
}

}  // namespace

std::optional<std::string_view> XmlTag::find(std::string_view attribute) const {
  for (const auto& [name, value] : attributes)
    if (name == attribute) return value;
  return std::nullopt;
}

bool XmlReader::next(XmlTag& tag) {
  while (true) {
    tag_start_ = bytes_.find('<', position_);
    if (tag_start_ == std::string_view::npos) return false;
    const std::string_view from = bytes_.substr(tag_start_);
    const std::string_view terminator = from.starts_with("<!--") ? "-->"
                                        : from.starts_with("<?") ? "?>"
                                                                 : ">";
    const std::size_t end = from.find(terminator);
    if (end == std::string_view::npos) fail_here("a tag does not end");
    position_ = tag_start_ + end + terminator.size();
    if (terminator != ">" || from.starts_with("<!")) continue;

    std::string_view body = from.substr(1, end - 1);
    tag = {};
    tag.closes = body.starts_with('/');
    if (tag.closes) body.remove_prefix(1);
    tag.closes_itself = body.ends_with('/');
    if (tag.closes_itself) body.remove_suffix(1);
    tag.name = body.substr(0, body.find_first_of(kSpace));
    parse_attributes(body.substr(tag.name.size()), tag);
    return true;
  }
}

void XmlReader::parse_attributes(std::string_view text, XmlTag& tag) const {
  for (skip_space(text); !text.empty(); skip_space(text)) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) fail_here("an attribute has no value");
    std::string_view name = text.substr(0, equals);
    name = name.substr(0, name.find_first_of(kSpace));
    text.remove_prefix(equals + 1);
    skip_space(text);
    const char quote = text.empty() ? '\0' : text[0];
    const std::size_t end = quote == '"' || quote == '\'' ? text.find(quote, 1) : std::string_view::npos;
    if (end == std::string_view::npos) fail_here("an attribute's value is not in quotes");
    tag.attributes.emplace_back(name, text.substr(1, end - 1));
    text.remove_prefix(end + 1);
  }
}

std::string_view XmlReader::text() const { return rest().substr(0, rest().find('<')); }

void XmlReader::fail_here(std::string_view message) const {
  const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(tag_start_, bytes_.size()));
  fail(ErrorCode::kFormat, "{}:{}: {}", name_, 1 + std::count(bytes_.begin(), end, '\n'), message);
}

}  // namespace unsliver::io
