#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// The items as an English list: "a", "a and b", "a, b and c", with the word `last` before the last item.
std::string inWords(const std::vector<std::string_view>& items, std::string_view last = "and");

/// "model a", "models a and b": a noun in singular or plural before the items.
std::string withNoun(std::string_view noun, const std::vector<std::string_view>& items);

}  // namespace fissure
