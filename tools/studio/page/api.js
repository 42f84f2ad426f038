// The API of the server: one function, and the token of a server that asks for one.

const fragment = new URLSearchParams(location.hash.slice(1));
if (fragment.has('token')) sessionStorage.setItem('token', fragment.get('token'));
const token = sessionStorage.getItem('token');

export class ApiError extends Error {
  constructor(error) {
    super(error.message);
    Object.assign(this, error);
  }
}

// path: "run"; body: an object, or the text of a file. Throws ApiError with the server's words.
export async function ask(path, body) {
  const options = { method: body === undefined ? 'GET' : 'POST', headers: {} };
  if (token) options.headers.Authorization = `Bearer ${token}`;
  if (body !== undefined) {
    options.headers['Content-Type'] = 'application/json';
    options.body = typeof body === 'string' ? body : JSON.stringify(body);
  }
  let response;
  try {
    response = await fetch(`/api/${path}`, options);
  } catch {
    throw new ApiError({ kind: 'network', message: 'the studio does not answer: is `waymark serve` still running?' });
  }
  const answer = await response.json();
  if (answer.error) throw new ApiError(answer.error);
  return answer;
}
