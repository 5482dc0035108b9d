// SPDX-License-Identifier: MIT
// Files are written whole or not at all.
#pragma once

#include <string>

namespace refitlab {

// Writes text to path. First it writes a temporary file of the same folder (made if missing), which is forced to the disk and
// then takes the name. A reader finds the old file or the new one, complete, even if the run is killed at any moment. If there
// are two writers, the last one wins. A killed writer may leave its temporary file, named path + ".tmp" and numbers. A symbolic
// link stays, and the file that it leads to is written. A device, a pipe or a socket takes the text and stays what it is.
// Throws std::runtime_error that names the path and the reason.
void write_whole(const std::string& path, const std::string& text);

// Throws the error of write_whole if it is sure to refuse this path, as far as that can be said before. Changes nothing. It is
// for those who compute long before they write.
void check_writable(const std::string& path);

// Returns all bytes of a file. Throws std::runtime_error that names the path and the reason.
std::string read_whole(const std::string& path);

}  // namespace refitlab
