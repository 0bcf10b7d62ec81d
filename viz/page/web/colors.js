// Colours with a meaning; the rest is in page.css. Left is blue and right is orange wherever feet
// are told apart, as in all of Amble's pictures.

export const kLeftColor = 0x1f69be;
export const kRightColor = 0xe17014;
export const kPathColor = 0xbe1e4b;
export const kStartColor = 0x1d7a45;
export const kGoalColor = 0xb3261e;

/** Of captured motions, standing first. */
export const kSourceColors = [
  '#98a2b3', '#7a5af8', '#b692f6', '#0e9384', '#15b79e', '#dd2590', '#f670c7', '#ca8504', '#4e5ba6',
];

export const kBackground = { light: 0xeceff3, dark: 0x15181d };
