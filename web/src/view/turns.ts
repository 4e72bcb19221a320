// The turning points of the record.

import type { App } from "../state";

/** More than anyone looks at. */
const MOST = 5000;

export const turns = (app: App) => app.state.solution.turningPoints(MOST);
