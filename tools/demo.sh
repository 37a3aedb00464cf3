#!/usr/bin/env bash
# One rendered picture on seven devices: demo.sh BUILD_DIR OUT_DIR
#
# OUT_DIR gets the picture as linear EXR, for each device its codes as PNG and a proof of what it would show,
# and sheet.png with all proofs side by side.
set -euo pipefail
if [ $# -ne 2 ]; then
  echo "use: $0 BUILD_DIR OUT_DIR" >&2
  exit 2
fi
tristim=$1/bin/tristim
contact_sheet=$1/bin/examples/contact_sheet
out=$2
mkdir -p "$out"

devices=(
  'crt-p22|CRT, P22 phosphors'
  'srgb|sRGB monitor'
  'vga16|VGA, 16 colours'
  'lcd-rgb565|LCD, RGB 5-6-5'
  'epaper-4grey|E-paper, 4 greys'
  'epaper-7color|E-paper, 7 colours'
  'laser-300|Laser printer, 300 dpi, 1 bit'
)

# width, height, mean CIEDE2000, bytes, seconds of the JSON that `tristim process` prints
figures() {
  python3 -c '
import json, sys
facts = json.load(sys.stdin)
print(facts["width"], facts["height"], "%.2f" % facts["mean_ciede2000"], facts["bytes"],
      "%.2f" % facts["seconds"])'
}

picture=$out/still-life.exr
"$tristim" render still-life --size 1280x720 -o "$picture" --force

captions=("Rendered light"$'\n'"1280 × 720 · linear EXR, clipped at 1=$picture")
printf '%-14s %-10s %14s %10s %8s\n' device size 'mean CIEDE2000' bytes seconds
for entry in "${devices[@]}"; do
  device=${entry%%|*}
  title=${entry#*|}
  facts=$("$tristim" process "$picture" --device "$device" --tone-map reinhard:6 \
    -o "$out/$device.png" --proof "$out/$device-proof.png" --json --quiet --force)
  read -r width height difference bytes seconds < <(figures <<<"$facts")
  printf '%-14s %-10s %14s %10s %8s\n' "$device" "${width}x$height" "$difference" "$bytes" "$seconds"
  note="$width × $height · $(((bytes + 512) / 1024)) KiB · mean ΔE₀₀ $difference"
  captions+=("$title"$'\n'"$note=$out/$device-proof.png")
done

"$contact_sheet" -o "$out/sheet.png" --force --columns 4 \
  --title 'One rendered picture, seven devices' "${captions[@]}"
echo "the seven results side by side: $out/sheet.png"
