// The report's section on scenes of many characters.
#pragma once

#include <sstream>

#include "experiments/growth/characters.hpp"

namespace refitlab {

// Nothing for no rows.
void write_characters_section(std::ostringstream& out, const std::vector<CharacterGrowth>& rows);

}  // namespace refitlab
