#!/usr/bin/env bash
# The README's first picture: docs/images/mission.png.
exec "$(dirname "${BASH_SOURCE[0]}")/take_screenshot.sh"
