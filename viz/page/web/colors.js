// Colours with a meaning; the rest is in page.css. Left is blue and right is orange wherever feet
// are told apart, as in all of Amble's pictures.

export const kLeftColor = 0x1f69be;
export const kRightColor = 0xe17014;
export const kPathColor = 0xbe1e4b;
export const kStartColor = 0x1d7a45;
export const kGoalColor = 0xb3261e;

export const kBackground = { light: 0xeceff3, dark: 0x15181d };
